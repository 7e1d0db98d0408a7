// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Box queries and ray casts in a world of 20,000 circles, per query.

#include <random>

#include "scree/world.h"
#include "tests/bench/micro.h"

namespace scree::bench {
namespace {

constexpr float side = 500.0f;
constexpr int queryCount = 64;

std::unique_ptr<World> MakeWorld(int count) {
    std::mt19937 random(9);
    const auto uniform = [&] { return side * static_cast<float>(random()) * 0x1p-32f; };
    auto world = std::make_unique<World>(Vec2{0.0f, 0.0f});
    CircleShape circle;
    circle.m_radius = 0.5f;
    for (int i = 0; i < count; ++i) {
        BodyDef def;
        def.type = dynamicBody;
        def.position = {uniform(), uniform()};
        world->CreateBody(&def)->CreateFixture(&circle, 1.0f);
    }
    world->Step(1.0f / 60.0f, 8, 3);
    return world;
}

/// Corners of queries, the same in every run.
std::vector<Vec2> MakePoints() {
    std::mt19937 random(11);
    std::vector<Vec2> points(queryCount);
    for (Vec2& p : points) {
        p.x = side * static_cast<float>(random()) * 0x1p-32f;
        p.y = side * static_cast<float>(random()) * 0x1p-32f;
    }
    return points;
}

void BenchQuery(benchmark::State& state, int bodies, float size) {
    const std::unique_ptr<World> world = MakeWorld(bodies);
    const std::vector<Vec2> points = MakePoints();
    int found = 0;
    for (auto _ : state) {
        for (const Vec2& p : points) {
            world->QueryAABB({p, p + Vec2{size, size}}, [&](Fixture*) {
                ++found;
                return true;
            });
        }
    }
    benchmark::DoNotOptimize(found);
    SetItems(state, queryCount, "query");
}

void BenchRay(benchmark::State& state, int bodies) {
    const std::unique_ptr<World> world = MakeWorld(bodies);
    const std::vector<Vec2> points = MakePoints();
    int hits = 0;
    for (auto _ : state) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            hits += world->RayCastClosest(points[i], points[points.size() - 1 - i]).has_value();
        }
    }
    benchmark::DoNotOptimize(hits);
    SetItems(state, queryCount, "query");
}

}  // namespace

void RegisterQueries() {
    benchmark::RegisterBenchmark("query/box-1m/smoke", BenchQuery, 100, 1.0f);
    benchmark::RegisterBenchmark("query/box-1m/20000", BenchQuery, 20000, 1.0f);
    benchmark::RegisterBenchmark("query/box-20m/20000", BenchQuery, 20000, 20.0f);
    benchmark::RegisterBenchmark("query/ray/smoke", BenchRay, 100);
    benchmark::RegisterBenchmark("query/ray/20000", BenchRay, 20000);
}

}  // namespace scree::bench
