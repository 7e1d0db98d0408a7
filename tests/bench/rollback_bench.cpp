// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Moments of a world of 1,000 boxes: in free fall, in stacks of 25, and asleep among 20,000; by the soft step and by
// sequential impulses. Beside them an image of the same world.

#include "scree/scree.h"
#include "tests/bench/micro.h"

namespace scree::bench {
namespace {

struct Case {
    const char* name;
    int bodies;
    int column;    ///< boxes above each other; 0: they fall apart from each other
    int substeps;  ///< 0: sequential impulses
    int before;    ///< steps taken
};

constexpr Case cases[] = {{"falling/smoke", 50, 0, 4, 5},         {"falling/soft", 1000, 0, 4, 30},
                          {"falling/sequential", 1000, 0, 0, 30}, {"stacks/soft", 1000, 25, 4, 60},
                          {"stacks/sequential", 1000, 25, 0, 60}, {"asleep/soft", 20000, 1, 4, 400}};

class Game {
public:
    explicit Game(const Case& what) : m_case(what) {
        PolygonShape ground, box;
        ground.SetAsBox(20000.0f, 1.0f);
        box.SetAsBox(0.5f, 0.5f);
        BodyDef def;
        m_world.CreateBody(&def)->CreateFixture(&ground, 0.0f);
        def.type = dynamicBody;
        for (int i = 0; i < what.bodies; ++i) {
            const auto x = static_cast<float>(what.column > 0 ? i / what.column : i % 40);
            const auto y = static_cast<float>(what.column > 0 ? i % what.column : i / 40);
            def.position = what.column > 0 ? Vec2{1.5f * x, 1.5f + 1.01f * y} : Vec2{4.0f * x, 400.0f + 4.0f * y};
            def.angularVelocity = what.column > 0 ? 0.0f : 0.01f * static_cast<float>(i % 100);
            def.linearVelocity.x = def.angularVelocity;
            m_world.CreateBody(&def)->CreateFixture(&box, 1.0f);
        }
        Step(what.before);
    }
    void Step(int count) {
        for (int i = 0; i < count; ++i) {
            m_case.substeps > 0 ? m_world.Step(1.0f / 60.0f, m_case.substeps) : m_world.Step(1.0f / 60.0f, 8, 3);
        }
    }
    World& GetWorld() { return m_world; }

private:
    const Case& m_case;
    World m_world{Vec2{0.0f, -10.0f}};
};

void Note(benchmark::State& state, const Case& what, size_t bytes) {
    state.counters["bytes/body"] = static_cast<double>(bytes) / what.bodies;
}

void BenchSave(benchmark::State& state, const Case& what) {
    Game game(what);
    Rollback moments(game.GetWorld());
    moments.Save();
    game.Step(8);
    int64_t moment = 0;
    for (int i = 0; i < 40; ++i) moment = moments.Save();  // every place has its memory
    for (auto _ : state) benchmark::DoNotOptimize(moment = moments.Save());
    Note(state, what, moments.GetBytes(moment));
}

void BenchRestore(benchmark::State& state, const Case& what) {
    Game game(what);
    Rollback moments(game.GetWorld());
    game.Step(8);
    const int64_t earlier = moments.Save();
    game.Step(8);
    const int64_t later = moments.Save();
    bool turn = false;
    for (auto _ : state) benchmark::DoNotOptimize(moments.Restore((turn = !turn) ? earlier : later));
    Note(state, what, moments.GetBytes(later));
}

void BenchImage(benchmark::State& state, const Case& what, bool restores) {
    Game game(what);
    const std::vector<std::byte> image = SaveWorld(game.GetWorld());
    for (auto _ : state) {
        if (restores) {
            benchmark::DoNotOptimize(RestoreWorld(game.GetWorld(), image));
        } else {
            benchmark::DoNotOptimize(SaveWorld(game.GetWorld()));
        }
    }
    Note(state, what, image.size());
}

}  // namespace

void RegisterRollback() {
    for (const Case& what : cases) {
        const std::string name = what.name;
        const auto with = [&](auto bench, auto... more) {
            return [=](benchmark::State& state) { bench(state, what, more...); };
        };
        benchmark::RegisterBenchmark(("rollback/save/" + name).c_str(), with(BenchSave));
        benchmark::RegisterBenchmark(("rollback/restore/" + name).c_str(), with(BenchRestore));
        benchmark::RegisterBenchmark(("image/save/" + name).c_str(), with(BenchImage, false));
        benchmark::RegisterBenchmark(("image/restore/" + name).c_str(), with(BenchImage, true));
    }
}

}  // namespace scree::bench
