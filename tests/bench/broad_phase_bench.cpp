// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Update of all moving boxes and pair finding, per algorithm and data set. The data are the boxes of two successive
// steps of a scene, taken in turn. So every iteration moves everything as a step does.

#include <map>
#include <random>

#include "broad_phase/broad_phase.h"
#include "tests/bench/micro.h"

namespace scree::bench {
namespace {

struct Proxy {
    uint32_t body;
    Motion motion;
    AABB boxes[2];  ///< in either step
};

using DataSet = std::vector<Proxy>;

AABB ToBox(const testbed::Box& box) { return {{box.lower.x, box.lower.y}, {box.upper.x, box.upper.y}}; }

DataSet Record(const std::string& scene, int steps) {
    const scenes::SceneInfo& info = *scenes::Find(scene);
    const auto run = RunScene(scenes::Build(scene, info.defaultSize), steps);
    DataSet data;
    for (int step = 0; step < 2; ++step) {
        testbed::Snapshot snapshot;
        run->Capture(snapshot, {.contacts = false, .joints = false, .nodes = false});
        data.resize(std::max(data.size(), snapshot.fixtures.size()));
        for (std::size_t i = 0; i < snapshot.fixtures.size(); ++i) {
            const testbed::FixtureState& f = snapshot.fixtures[i];
            const auto type = snapshot.bodies[static_cast<std::size_t>(f.body)].type;
            data[i].body = static_cast<uint32_t>(f.body);
            data[i].motion = type == scenes::BodyType::isStatic ? Motion::isStatic : Motion::dynamic;
            data[i].boxes[step] = ToBox(f.tight);
            if (step == 0) data[i].boxes[1] = data[i].boxes[0];
        }
        if (step == 0) run->Step();
    }
    return data;
}

/// Sizes over three decades: hard for grids, harmless for trees.
DataSet LogUniform(int count) {
    std::mt19937 random(3);
    const auto uniform = [&] { return static_cast<float>(random()) * 0x1p-32f; };
    DataSet data;
    for (int i = 0; i < count; ++i) {
        const float half = 0.05f * std::pow(1000.0f, uniform());
        const Vec2 center{4000.0f * uniform(), 4000.0f * uniform()};
        const Vec2 moved = center + Vec2{0.1f * uniform(), 0.1f * uniform()};
        const Vec2 extent{half, half};
        data.push_back({static_cast<uint32_t>(i),
                        Motion::dynamic,
                        {{center - extent, center + extent}, {moved - extent, moved + extent}}});
    }
    return data;
}

/// Made at the first use: recording the scenes takes longer than most benchmarks.
const DataSet& GetData(const std::string& name) {
    static std::map<std::string, DataSet> sets;
    const auto found = sets.find(name);
    if (found != sets.end()) return found->second;
    if (name == "smoke") return sets[name] = LogUniform(200);
    if (name == "log-uniform") return sets[name] = LogUniform(20000);
    return sets[name] = Record(name, 60);
}

void BenchFindPairs(benchmark::State& state, BroadPhaseKind kind, const std::string& name) {
    const DataSet& data = GetData(name);
    const std::unique_ptr<BroadPhase> broadPhase = CreateBroadPhase(kind);
    std::vector<uint32_t> movers;
    for (uint32_t i = 0; i < data.size(); ++i) {
        broadPhase->Insert(i, data[i].body, data[i].motion, data[i].boxes[0]);
        if (data[i].motion != Motion::isStatic) movers.push_back(i);
    }
    std::vector<Pair> pairs;
    broadPhase->FindPairs(pairs);
    int now = 0;
    for (auto _ : state) {
        const int before = now;
        now = 1 - now;
        for (const uint32_t i : movers) {
            const Proxy& p = data[i];
            broadPhase->Update(i, p.boxes[now], p.boxes[now].GetCenter() - p.boxes[before].GetCenter());
        }
        broadPhase->FindPairs(pairs);
        benchmark::DoNotOptimize(pairs.data());
    }
    SetItems(state, static_cast<double>(movers.size()), "box");
    state.counters["pairs"] = static_cast<double>(pairs.size());
}

void BenchBuild(benchmark::State& state, BroadPhaseKind kind, const std::string& name) {
    const DataSet& data = GetData(name);
    std::vector<Pair> pairs;
    for (auto _ : state) {
        const std::unique_ptr<BroadPhase> broadPhase = CreateBroadPhase(kind);
        for (uint32_t i = 0; i < data.size(); ++i)
            broadPhase->Insert(i, data[i].body, data[i].motion, data[i].boxes[0]);
        broadPhase->FindPairs(pairs);
        benchmark::DoNotOptimize(pairs.data());
    }
    SetItems(state, static_cast<double>(data.size()), "box");
}

}  // namespace

void RegisterBroadPhase() {
    for (const char* data : {"smoke", "slow-explosion", "falling-squares", "tumbler", "big-mobile", "mixed", "n2",
                             "mild-n2", "mostly-static-single", "tiles", "log-uniform"}) {
        for (std::size_t k = 1; k < broadPhaseNames.size(); ++k) {
            const auto kind = static_cast<BroadPhaseKind>(k);
            const std::string name = std::string(broadPhaseNames[k]) + "/" + data;
            benchmark::RegisterBenchmark(("detect/" + name).c_str(), BenchFindPairs, kind, data);
            benchmark::RegisterBenchmark(("create/" + name).c_str(), BenchBuild, kind, data);
        }
    }
}

}  // namespace scree::bench
