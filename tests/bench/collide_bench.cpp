// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The collision function of every pair of shapes, those that go eight at a time, the distance, and the time of impact.
// They run over 256 random poses of which about half touch: per call.

#include <array>
#include <random>
#include <stdexcept>

#include "geometry/collide_quads.h"
#include "scree/collision.h"
#include "scree/convex_shape.h"
#include "scree/distance.h"
#include "scree/time_of_impact.h"
#include "tests/bench/micro.h"

namespace scree::bench {
namespace {

constexpr int poseCount = 256;

std::array<Transform, poseCount> MakePoses() {
    std::mt19937 random(5);
    const auto uniform = [&](float low, float high) {
        return low + (high - low) * static_cast<float>(random()) * 0x1p-32f;
    };
    std::array<Transform, poseCount> poses;
    // Shapes of size 1 around the origin: those up to 1.2 m away touch, the others do not.
    for (Transform& pose : poses) pose.Set({uniform(-1.2f, 1.2f), uniform(-1.2f, 1.2f)}, uniform(-3.0f, 3.0f));
    return poses;
}

/// Calls collide(manifold, pose) for pose after pose.
template <typename Collide>
void Run(benchmark::State& state, const Collide& collide) {
    const auto poses = MakePoses();
    int points = 0;
    for (auto _ : state) {
        for (const Transform& pose : poses) {
            Manifold manifold;
            collide(&manifold, pose);
            points += manifold.pointCount;
        }
    }
    benchmark::DoNotOptimize(points);
    SetItems(state, poseCount, "call");
}

template <typename Collide>
void Register(const char* name, const Collide& collide) {
    benchmark::RegisterBenchmark(name, [collide](benchmark::State& state) { Run(state, collide); });
}

/// The same poses of `b` before `a`, in batches.
template <typename Batch, typename A, typename B>
void RegisterBatch(const char* name, const A& a, const B& b, const Batch& empty = Batch()) {
    benchmark::RegisterBenchmark(name, [=](benchmark::State& state) {
        const auto poses = MakePoses();
        Transform origin;
        origin.SetIdentity();
        Batch batch = empty;
        int points = 0;
        for (auto _ : state) {
            for (int i = 0; i < poseCount; ++i) {
                batch.Add(i, a, origin, b, poses[static_cast<size_t>(i)]);
                if (!batch.IsFull()) continue;
                batch.Collide();
                for (int pair = 0; pair < batch.Size(); ++pair) {
                    Manifold manifold;
                    batch.Write(pair, manifold);
                    points += manifold.pointCount;
                }
                batch.Clear();
            }
        }
        benchmark::DoNotOptimize(points);
        SetItems(state, poseCount, "call");
    });
}

PolygonShape MakeBox() {
    PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    return box;
}

PolygonShape MakeOctagon() {
    Vec2 vertices[8];
    for (int i = 0; i < 8; ++i) {
        const Rot rot(static_cast<float>(i) * 0.785398f);
        vertices[i] = {0.5f * rot.c, 0.5f * rot.s};
    }
    PolygonShape octagon;
    if (!octagon.Set(vertices, 8)) throw std::logic_error("eight points of a circle are convex");
    return octagon;
}

CircleShape MakeCircle() {
    CircleShape circle;
    circle.m_radius = 0.5f;
    return circle;
}

ConvexShape MakeLimb() { return MakeCapsule({-0.4f, 0.0f}, {0.4f, 0.0f}, 0.3f); }

ConvexShape MakeRoundedBox() {
    PolygonShape core;
    core.SetAsBox(0.4f, 0.4f);
    return MakeRoundedPolygon(core.m_vertices, 4, 0.1f);
}

EdgeShape MakeEdge() {
    EdgeShape edge;
    edge.SetTwoSided({-1.0f, 0.0f}, {1.0f, 0.0f});
    return edge;
}

void BenchDistance(benchmark::State& state) {
    const PolygonShape box = MakeBox(), octagon = MakeOctagon();
    const auto poses = MakePoses();
    DistanceInput input;
    input.proxyA.Set(&box, 0);
    input.proxyB.Set(&octagon, 0);
    input.transformA.SetIdentity();
    input.useRadii = true;
    float sum = 0;
    for (auto _ : state) {
        for (const Transform& pose : poses) {
            input.transformB = pose;
            input.transformB.p.x += 2.0f;  // apart: the case that continuous collision meets
            SimplexCache cache{};
            DistanceOutput output;
            Distance(&output, &cache, &input);
            sum += output.distance;
        }
    }
    benchmark::DoNotOptimize(sum);
    SetItems(state, poseCount, "call");
}

void BenchTimeOfImpact(benchmark::State& state) {
    const PolygonShape box = MakeBox(), octagon = MakeOctagon();
    const auto poses = MakePoses();
    TOIInput input;
    input.proxyA.Set(&box, 0);
    input.proxyB.Set(&octagon, 0);
    input.tMax = 1.0f;
    input.sweepA = {};
    int hits = 0;
    for (auto _ : state) {
        for (const Transform& pose : poses) {
            input.sweepB = {};
            input.sweepB.c0 = pose.p + Vec2{4.0f, 0.0f};
            input.sweepB.c = pose.p + Vec2{-4.0f, 0.0f};
            input.sweepB.a0 = pose.q.GetAngle();
            input.sweepB.a = input.sweepB.a0 + 0.5f;
            TOIOutput output;
            TimeOfImpact(&output, &input);
            hits += output.state == TOIOutput::e_touching;
        }
    }
    state.counters["touching"] = static_cast<double>(hits) / static_cast<double>(state.iterations() * poseCount);
    SetItems(state, poseCount, "call");
}

}  // namespace

void RegisterCollide() {
    Transform origin;
    origin.SetIdentity();
    const PolygonShape box = MakeBox(), octagon = MakeOctagon();
    const CircleShape circle = MakeCircle();
    const EdgeShape edge = MakeEdge();
    const ConvexShape capsule = MakeLimb(), rounded = MakeRoundedBox();
    Register("collide/circle-circle",
             [=](Manifold* m, const Transform& pose) { CollideCircles(m, &circle, origin, &circle, pose); });
    Register("collide/box-circle",
             [=](Manifold* m, const Transform& pose) { CollidePolygonAndCircle(m, &box, origin, &circle, pose); });
    Register("collide/box-box",
             [=](Manifold* m, const Transform& pose) { CollidePolygons(m, &box, origin, &box, pose); });
    RegisterBatch<QuadBatch>("collide/box-box/eight", box, box);
    RegisterBatch<QuadDiskBatch>("collide/box-circle/eight", box, circle);
    Register("collide/capsule-capsule",
             [=](Manifold* m, const Transform& pose) { CollideConvex(m, &capsule, origin, &capsule, pose); });
    Register("collide/box-capsule",
             [=](Manifold* m, const Transform& pose) { CollideConvex(m, &box, origin, &capsule, pose); });
    Register("collide/capsule-circle",
             [=](Manifold* m, const Transform& pose) { CollideConvex(m, &capsule, origin, &circle, pose); });
    Register("collide/octagon-capsule",
             [=](Manifold* m, const Transform& pose) { CollideConvex(m, &octagon, origin, &capsule, pose); });
    Register("collide/rounded-rounded",
             [=](Manifold* m, const Transform& pose) { CollideConvex(m, &rounded, origin, &rounded, pose); });
    RegisterBatch("collide/capsule-capsule/eight", capsule, capsule, CoreBatch(CorePair(capsule, capsule)));
    RegisterBatch("collide/box-capsule/eight", box, capsule, CoreBatch(CorePair(box, capsule)));
    RegisterBatch("collide/rounded-rounded/eight", rounded, rounded, CoreBatch(CorePair(rounded, rounded)));
    Register("collide/octagon-octagon",
             [=](Manifold* m, const Transform& pose) { CollidePolygons(m, &octagon, origin, &octagon, pose); });
    Register("collide/edge-circle",
             [=](Manifold* m, const Transform& pose) { CollideEdgeAndCircle(m, &edge, origin, &circle, pose); });
    Register("collide/edge-box",
             [=](Manifold* m, const Transform& pose) { CollideEdgeAndPolygon(m, &edge, origin, &box, pose); });
    benchmark::RegisterBenchmark("collide/distance", BenchDistance);
    benchmark::RegisterBenchmark("toi/box-octagon", BenchTimeOfImpact);
}

}  // namespace scree::bench
