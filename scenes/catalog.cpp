// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The table of scenes, look-up by exact and by nearest name, and checked building.

#include "scenes/catalog.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace scenes {

// Each is defined in the file of its name.
Scene AddPair(int n);
Scene AddPair400(int n);
Scene BigMobile(int n);
Scene Diagonal(int n);
Scene FallingCircles(int n);
Scene FallingSquares(int n);
Scene MildNSquared(int n);
Scene Mixed(int n);
Scene MostlyStaticMulti(int n);
Scene MostlyStaticSingle(int n);
Scene MultiFixture(int n);
Scene NSquared(int n);
Scene SlowExplosion(int n);
Scene Tiles(int n);
Scene Tumbler(int n);

namespace {

// maxSize: about 2e6 bodies or fixtures, or about 5e6 overlapping pairs, whichever comes first (scenes/README.md).
constexpr SceneInfo catalog[] = {
    {.name = "tiles",
     .title = "an inverted pyramid of boxes falls onto a ground of 2000 fixtures",
     .exercises = "broad phase: many equal boxes that start to fall together, and a static body of many fixtures",
     .folder = "piles",
     .defaultSize = 200,
     .maxSize = 2000,
     .sweep = Sweep{20, 200, 20},
     .steps = 100,
     .showStep = 90,
     .build = Tiles},
    {.name = "add-pair-400",
     .title = "a fast box shoots into 400 circles at random places",
     .exercises = "broad phase: sudden fast motion of many small bodies",
     .folder = "fast",
     .hasSize = false,
     .defaultSize = 400,
     .minSize = 400,
     .maxSize = 400,
     .steps = 100,
     .showStep = 20,
     .build = AddPair400},
    {.name = "falling-squares",
     .title = "15 columns of squares of growing size collapse onto a ground",
     .exercises = "a settling heap: contacts, solver, continuous collision",
     .folder = "piles",
     .defaultSize = 300,
     .maxSize = 135000,
     .sweep = Sweep{10, 300, 10},
     .steps = 1300,
     .showStep = 600,
     .build = FallingSquares},
    {.name = "falling-circles",
     .title = "15 leaning columns of circles fall onto a ground",
     .exercises = "a settling heap of circles: contacts, broad phase in free fall",
     .folder = "piles",
     .defaultSize = 300,
     .maxSize = 135000,
     .sweep = Sweep{10, 300, 10},
     .steps = 1300,
     .showStep = 600,
     .build = FallingCircles},
    {.name = "tumbler",
     .title = "a motor turns a drum into which one small box falls after each step",
     .exercises = "bodies created during the run, constant churn of contacts, a motor against a heavy load",
     .folder = "piles",
     .defaultSize = 1000,
     .maxSize = 10000,
     .sweep = Sweep{50, 1000, 50},
     .steps = 1500,
     .showStep = 1000,
     .build = Tumbler},
    {.name = "multi-fixture",
     .title = "tables cut into up to 150 fixtures each fall into a tray",
     .exercises = "bodies of many fixtures: contacts between few bodies, pair filtering",
     .folder = "piles",
     .defaultSize = 100,
     .maxSize = 10000,
     .sweep = Sweep{5, 100, 5},
     .steps = 500,
     .showStep = 120,
     .build = MultiFixture},
    {.name = "add-pair",
     .title = "a fast box shoots through a cloud of resting circles",
     .exercises = "many pairs added and removed in a step",
     .folder = "fast",
     .defaultSize = 2000,
     .maxSize = 50000,
     .sweep = Sweep{100, 2500, 100},
     .steps = 1000,
     .showStep = 18,
     .build = AddPair},
    {.name = "mild-n2",
     .title = "tables all on one spot and spaceships all on another",
     .exercises = "quadratically many true pairs, several fixtures a body",
     .folder = "overlapping",
     .defaultSize = 200,
     .maxSize = 1000,
     .sweep = Sweep{10, 200, 10},
     .steps = 100,
     .showStep = 30,
     .build = MildNSquared},
    {.name = "n2",
     .title = "circles nearly on one spot",
     .exercises = "quadratically many true pairs, where no broad phase can help",
     .folder = "overlapping",
     .defaultSize = 750,
     .maxSize = 20000,
     .sweep = Sweep{25, 750, 25},
     .steps = 100,
     .showStep = 30,
     .build = NSquared},
    {.name = "mostly-static-single",
     .title = "circles slide through a corridor in one static body of many boxes",
     .exercises = "few moving bodies among very many static fixtures of one body",
     .folder = "static",
     .defaultSize = 200,
     .maxSize = 1400,
     .sweep = Sweep{10, 200, 5},
     .steps = 400,
     .showStep = 150,
     .build = MostlyStaticSingle},
    {.name = "mostly-static-multi",
     .title = "circles slide through a corridor between very many static bodies",
     .exercises = "few moving bodies among very many static bodies",
     .folder = "static",
     .defaultSize = 200,
     .maxSize = 1400,
     .sweep = Sweep{10, 200, 5},
     .steps = 500,
     .showStep = 150,
     .build = MostlyStaticMulti},
    {.name = "diagonal",
     .title = "3000 circles rain through rows of slabs turned by 45 degrees",
     .exercises = "large overlapping static bounding boxes, continuous collision with thin walls",
     .folder = "static",
     .defaultSize = 50,
     .minSize = 2,
     .maxSize = 500,
     .sweep = Sweep{2, 50, 2},
     .steps = 1000,
     .showStep = 400,
     .build = Diagonal},
    {.name = "mixed",
     .title = "a spiral of circles explodes inside a static ring of circles",
     .exercises = "static and moving fixtures in like numbers, continuous collision at speed",
     .folder = "explosions",
     .defaultSize = 6000,
     .maxSize = 50000,
     .sweep = Sweep{100, 6000, 100},
     .steps = 400,
     .showStep = 60,
     .build = Mixed},
    {.name = "slow-explosion",
     .title = "circles on a spiral drift apart without gravity",
     .exercises = "everything moves, little touches: broad phase and integration alone",
     .folder = "explosions",
     .defaultSize = 6000,
     .maxSize = 2000000,
     .sweep = Sweep{100, 6000, 100},
     .steps = 1000,
     .showStep = 100,
     .build = SlowExplosion},
    {.name = "big-mobile",
     .title = "a hanging binary tree of bars on revolute joints",
     .exercises = "one large island of joints, long bounding boxes",
     .folder = "joints",
     .defaultSize = 11,
     .maxSize = 16,
     .sweep = Sweep{1, 11, 1},
     .steps = 1000,
     .showStep = 300,
     .build = BigMobile},
};

// Levenshtein's distance by the usual two-row recurrence.
std::size_t EditDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

const SceneInfo& FindOrThrow(std::string_view name) {
    if (const SceneInfo* info = Find(name)) return *info;
    std::string message = "unknown scene '" + std::string(name) + "'; nearest:";
    std::string_view separator = " ";
    for (std::string_view near : NearestNames(name)) {
        message.append(separator).append(near);
        separator = ", ";
    }
    throw std::invalid_argument(message);
}

void CheckSize(const SceneInfo& info, int size) {
    if (size >= info.minSize && size <= info.maxSize) return;
    std::string message = "scene '" + std::string(info.name) + "': size " + std::to_string(size) + " is not legal; ";
    if (info.hasSize) {
        message += "it must be " + std::to_string(info.minSize) + " to " + std::to_string(info.maxSize) + " (default " +
                   std::to_string(info.defaultSize) + ")";
    } else {
        message += "the scene has no size parameter, its size is always " + std::to_string(info.defaultSize);
    }
    throw std::out_of_range(message);
}

Scene BuildRow(const SceneInfo& info, int size) {
    Scene scene = info.build(size);
    scene.name = info.name;
    scene.size = size;
    if (scene.steps == 0) scene.steps = info.steps;
    if (scene.showStep == 0) scene.showStep = info.showStep;
    return scene;
}

}  // namespace

std::span<const SceneInfo> Catalog() { return catalog; }

const SceneInfo* Find(std::string_view name) {
    const auto row = std::ranges::find(catalog, name, &SceneInfo::name);
    return row == std::end(catalog) ? nullptr : row;
}

std::vector<std::string_view> NearestNames(std::string_view name, int count) {
    std::vector<std::pair<std::size_t, std::string_view>> ranked;
    for (const SceneInfo& info : catalog) ranked.emplace_back(EditDistance(name, info.name), info.name);
    std::ranges::stable_sort(ranked, {}, &std::pair<std::size_t, std::string_view>::first);
    std::vector<std::string_view> names;
    for (const auto& [distance, near] : ranked) {
        if (static_cast<int>(names.size()) == count) break;
        names.push_back(near);
    }
    return names;
}

Scene Build(std::string_view name) {
    const SceneInfo& info = FindOrThrow(name);
    return BuildRow(info, info.defaultSize);
}

Scene Build(std::string_view name, int size) {
    const SceneInfo& info = FindOrThrow(name);
    CheckSize(info, size);
    return BuildRow(info, size);
}

}  // namespace scenes
