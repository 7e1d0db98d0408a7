// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A world that runs for ever. Bodies, fixtures and joints come and go in every step, and sensors and listeners' events
// are read. Memory must stay what it is after the first tenth. Argument: how many steps (a million). Exit code 1 if the
// tables of the world or the heap have grown by more than a tenth since then, or if any number is not finite.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <deque>
#include <system_error>

#include "scenes/build.h"
#include "scree/inspect.h"
#include "scree/scree.h"

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace {

size_t HeapBytes() {
#if defined(__GLIBC__)
    return mallinfo2().uordblks + mallinfo2().hblkhd;
#else
    return 0;
#endif
}

size_t TableBytes(const scree::World& world) {
    const scree::inspect::MemoryUse use = scree::inspect::GetMemoryUse(world);
    return use.bodies + use.fixtures + use.contacts + use.joints + use.broadPhase;
}

/// A box of walls with a hundred bodies that live a few hundred steps each.
class Churn {
public:
    Churn() : m_world(scree::Vec2{0.0f, -10.0f}) {
        scree::BodyDef def;
        m_walls = m_world.CreateBody(&def);
        const scree::Vec2 corners[] = {{-15.0f, 0.0f}, {-15.0f, 40.0f}, {15.0f, 40.0f}, {15.0f, 0.0f}};
        scree::ChainShape chain;  // clockwise: collides inside
        if (chain.CreateLoop(corners, 4)) m_walls->CreateFixture(&chain, 0.0f);
        scree::FixtureDef sensor;
        scree::PolygonShape zone;
        zone.SetAsBox(3.0f, 3.0f, {0.0f, 5.0f}, 0.0f);
        sensor.shape = &zone;
        sensor.isSensor = true;
        sensor.reports = scree::Report::all;
        m_walls->CreateFixture(&sensor);
    }

    void Step(int step) {
        constexpr size_t mostBodies = 100;
        if (step % 3 == 0) Add();
        while (m_bodies.size() > mostBodies) {
            m_world.DestroyBody(m_bodies.front());  // and its joints
            m_bodies.pop_front();
        }
        const int kind = step / 1000 % 3;
        kind == 0   ? m_world.Step(1.0f / 60.0f, 4)
        : kind == 1 ? m_world.Step(1.0f / 60.0f, 8, 3)
                    : m_world.Step(1.0f / 60.0f, scree::Tolerance{});
        m_events += m_world.GetEvents().sensorsEntered.size();
        for (const scree::Body* body : m_bodies) m_isFinite &= body->GetPosition().IsValid();
    }
    [[nodiscard]] const scree::World& GetWorld() const { return m_world; }
    [[nodiscard]] bool IsFinite() const { return m_isFinite; }
    [[nodiscard]] size_t GetEventCount() const { return m_events; }

private:
    float Uniform(double low, double high) { return static_cast<float>(m_random.Uniform(low, high)); }

    void Add() {
        scree::BodyDef def;
        def.type = scree::dynamicBody;
        def.position = {Uniform(-12.0, 12.0), Uniform(20.0, 38.0)};
        def.angle = Uniform(0.0, 6.0);
        def.linearVelocity = {Uniform(-5.0, 5.0), Uniform(-5.0, 5.0)};
        def.bullet = m_random.Next() % 16 == 0;
        scree::Body* body = m_world.CreateBody(&def);
        const uint32_t kind = m_random.Next() % 4;
        scree::CircleShape circle;
        circle.m_radius = Uniform(0.2, 0.6);
        scree::PolygonShape box;
        box.SetAsBox(Uniform(0.2, 0.8), Uniform(0.2, 0.8));
        if (kind == 0) body->CreateFixture(&circle, 1.0f);
        if (kind == 1 || kind == 2) body->CreateFixture(&box, 1.0f);
        if (kind > 1) {
            const scree::ConvexShape capsule = scree::MakeCapsule({-0.5f, 0.0f}, {0.5f, 0.0f}, 0.2f);
            body->CreateFixture(&capsule, 1.0f);
        }
        if (!m_bodies.empty() && m_random.Next() % 4 == 0) {
            scree::DistanceJointDef rope;
            rope.Initialize(m_bodies.back(), body, m_bodies.back()->GetPosition(), def.position);
            rope.maxLength = rope.length;
            m_world.CreateJoint(&rope);
        }
        m_bodies.push_back(body);
    }

    scree::World m_world;
    scree::Body* m_walls = nullptr;
    std::deque<scree::Body*> m_bodies;
    scenes::Random m_random{20};
    bool m_isFinite = true;
    size_t m_events = 0;
};

}  // namespace

int main(int argc, char** argv) {
    constexpr int leastSteps = 1000;
    int steps = 1000000;
    bool isGood = argc <= 2;
    if (argc == 2) {
        const char* const end = argv[1] + std::strlen(argv[1]);
        const auto [parsed, error] = std::from_chars(argv[1], end, steps);
        isGood = error == std::errc() && parsed == end && steps >= leastSteps;
    }
    if (!isGood) {
        std::fprintf(stderr, "usage: scree_soak [STEPS], a number from %d on; a million without it\n", leastSteps);
        return 2;
    }
    Churn churn;
    size_t tables = 0, heap = 0, mostTables = 0, mostHeap = 0;
    for (int step = 0; step < steps; ++step) {
        churn.Step(step);
        if (step % (steps / 1000) != 0) continue;
        mostTables = std::max(mostTables, TableBytes(churn.GetWorld()));
        mostHeap = std::max(mostHeap, HeapBytes());
        if (step >= steps / 10 && tables == 0) tables = mostTables, heap = mostHeap;
    }
    std::printf("%d steps, %zu events; most bytes in the first tenth and in all: tables %zu, %zu; heap %zu, %zu\n",
                steps, churn.GetEventCount(), tables, mostTables, heap, mostHeap);
    const bool isFlat = mostTables <= tables + tables / 10 && mostHeap <= heap + heap / 10;
    if (!isFlat) std::printf("memory has grown\n");
    if (!churn.IsFinite()) std::printf("a position is not finite\n");
    return isFlat && churn.IsFinite() ? 0 : 1;
}
