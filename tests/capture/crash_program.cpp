// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// crash_program segv|abort|throw: a game with a flight recorder and the crash handler of testbed/docs/own-world.md. In
// step 281 a ball is shot through a wall, in step 320 the program crashes. crash.track has the seconds before.

#include <scree_capture_box2d.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace {

scree_capture::Track* recorder = nullptr;

void OnCrash(int number) {
    std::signal(number, SIG_DFL);  // a fault in here ends the program
    alarm(10);                     // and so does a lock that the crash left locked
    if (recorder != nullptr) recorder->Save();
    std::raise(number);
}

b2Body* MakeBall(b2World& world) {
    b2BodyDef def;
    b2EdgeShape wall;
    wall.SetTwoSided({0.0f, -5.0f}, {0.0f, 5.0f});
    world.CreateBody(&def)->CreateFixture(&wall, 0.0f);
    def.type = b2_dynamicBody;
    def.position.Set(-5.0f, 0.0f);
    b2CircleShape circle;
    circle.m_radius = 0.1f;
    b2Body* ball = world.CreateBody(&def);
    ball->CreateFixture(&circle, 1.0f);
    return ball;
}

void Crash(const std::string& kind) {
    if (kind == "abort") std::abort();
    if (kind == "throw") throw std::runtime_error("nobody catches this");
    // No page is mapped there. A sanitizer would report a store to null and exit.
    volatile int* volatile nowhere = reinterpret_cast<int*>(uintptr_t{16});
    *nowhere = 1;
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) return 2;
    b2World world({0.0f, 0.0f});
    world.SetContinuousPhysics(false);
    b2Body* ball = MakeBall(world);
    scree_capture::Track track(world, "crash.track");
    track.KeepLast(1.0);
    track.Name(ball, "shot");
    recorder = &track;
    std::signal(SIGSEGV, OnCrash);
    std::signal(SIGABRT, OnCrash);
    for (int step = 1; step <= 320; ++step) {
        if (step == 281) ball->SetLinearVelocity({100.0f, 0.0f});
        world.Step(1.0f / 60.0f, 8, 3);
        track.Step(1.0f / 60.0f);
    }
    Crash(arguments[1]);
    return 0;
}
