// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The same world on one thread, on three, and on tasks of the program: the same bits.

#include <cstdint>
#include <cstdio>
#include <future>

#include "scree/inspect.h"
#include "scree/scree.h"

namespace {

uint64_t Simulate(scree::World& world) {
    scree::BodyDef groundDef;
    scree::EdgeShape edge;
    edge.SetTwoSided({-200.0f, 0.0f}, {200.0f, 0.0f});
    world.CreateBody(&groundDef)->CreateFixture(&edge, 0.0f);
    scree::BodyDef def;
    def.type = scree::dynamicBody;
    scree::CircleShape circle;
    circle.m_radius = 0.5f;
    for (int i = 0; i < 1000; ++i) {
        def.position = {static_cast<float>(i % 50) - 25.0f + 0.01f * static_cast<float>(i / 50),
                        1.0f + static_cast<float>(i / 50)};
        world.CreateBody(&def)->CreateFixture(&circle, 1.0f);
    }
    for (int step = 0; step < 60; ++step) world.Step(1.0f / 60.0f, scree::Accuracy::game);
    return scree::inspect::GetStateHash(world);
}

uint64_t SimulateOnThreads(int workers) {
    scree::WorldDef worldDef;
    worldDef.workerCount = workers;
    scree::World world(worldDef);
    return Simulate(world);
}

uint64_t SimulateOnTasks(int workers) {
    scree::WorldDef worldDef;
    worldDef.workerCount = workers;
    // In place of a task system: a thread for each task.
    worldDef.tasks.enqueue = [](void (*task)(void*), void* taskContext, void* /*userContext*/) -> void* {
        return new std::future<void>(std::async(std::launch::async, task, taskContext));
    };
    worldDef.tasks.finish = [](void* handle, void* /*userContext*/) {
        delete static_cast<std::future<void>*>(handle);  // waits until the task is done
    };
    scree::World world(worldDef);
    return Simulate(world);
}

}  // namespace

int main() {
    const uint64_t one = SimulateOnThreads(1);
    std::printf("one thread and three: %s\n", one == SimulateOnThreads(3) ? "equal" : "different");
    std::printf("one thread and three tasks: %s\n", one == SimulateOnTasks(3) ? "equal" : "different");
}

// Output:
// one thread and three: equal
// one thread and three tasks: equal
