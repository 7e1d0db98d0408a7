// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The list of reference pictures. What a scene gets depends on its own name alone, so that a new scene or a new set
// changes no picture that exists.

#include "testbed/jobs/snapshot/catalog.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "scenes/catalog.h"
#include "testbed/base/hash.h"

namespace testbed {

namespace {

enum class When : unsigned char { early, late, both };

struct SnapshotSet {
    std::string_view name, kind, layers;
    int group;  ///< 0 … groupCount − 1: only scenes of this group have it; anyGroup: all
    When when;
    std::string_view theme = "dark";
    std::string_view settings = "";
};
constexpr int groupCount = 3, anyGroup = -1;

constexpr SnapshotSet snapshotSets[] = {
    {"overlap", "overlap", "internal", anyGroup, When::both},
    {"contacts", "render", "bodies,contacts,normals,impulses", 0, When::late},
    {"labels", "render", "bodies,labels", 0, When::early},
    {"islands", "render", "bodies,islands,contacts", 1, When::late},
    {"boxes", "render", "bodies,aabbs", 1, When::early},
    {"bvh", "render", "bodies,bvh", 2, When::late},
    {"joints", "render", "bodies,joints", 2, When::early},
    {"velocities", "render", "bodies,velocities", 0, When::early},
    {"swept", "render", "bodies,aabbs-swept,aabbs-fattened", 1, When::early},
    {"partitions", "render", "bodies,partitions", 2, When::late},
    {"light", "render", "bodies,joints,contacts,impulses", 0, When::late, "light"},
    {"light-overlap", "overlap", "levels=0..4", 1, When::late, "light"},
    {"light-islands", "render", "islands,velocities,labels", 2, When::early, "light"},
    // What users run: both ends of the dial, a tolerance, and continuous collision, which the sets above have off.
    {"soft", "render", "bodies,contacts,normals,impulses", anyGroup, When::late, "dark", "solver=soft@4 continuous=on"},
    {"precise", "render", "bodies,contacts,impulses", 0, When::late, "dark", "accuracy=precise continuous=on"},
    {"tolerance", "render", "bodies,joints,contacts,impulses", 1, When::late, "dark", "tolerance=0.01 continuous=on"},
    {"continuous", "render", "bodies,contacts,velocities", 2, When::late, "dark", "continuous=on"},
};

/// Scenes with sizes are halved until no more fixtures move than this: the whole check stays a matter of seconds.
constexpr int maxMovingFixtures = 400;

/// By a hash of the name.
int GroupOf(std::string_view scene) {
    Fnv1a<uint32_t> hash;
    hash.Add(scene);
    return static_cast<int>((hash.Get() >> 8) % groupCount);
}

int ChooseSize(const scenes::SceneInfo& info) {
    int size = info.defaultSize;
    while (size > info.minSize && scenes::Count(info.build(size)).movingFixtures > maxMovingFixtures) {
        size = std::max(info.minSize, size / 2);
    }
    return size;
}

}  // namespace

std::vector<SnapshotCase> GetSnapshotCatalog() {
    std::vector<SnapshotCase> cases;
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        const int size = ChooseSize(info), group = GroupOf(info.name);
        const auto first = static_cast<std::ptrdiff_t>(cases.size());
        for (const When when : {When::early, When::late}) {
            // A third of the way bodies fly, at the end they touch.
            const int step = when == When::late ? info.showStep : std::max(1, info.showStep / 3);
            for (const SnapshotSet& set : snapshotSets) {
                if (set.group != anyGroup && set.group != group) continue;
                if (set.when != When::both && set.when != when) continue;
                cases.push_back({std::string(info.name), size, step, fmt::format("step-{:04}-{}", step, set.name),
                                 std::string(set.kind), std::string(set.layers), std::string(set.theme),
                                 std::string(set.settings)});
            }
        }
        // What is run in another way comes after what is run in the usual one, each way by itself.
        std::stable_sort(cases.begin() + first, cases.end(),
                         [](const SnapshotCase& a, const SnapshotCase& b) { return a.settings < b.settings; });
    }
    return cases;
}

}  // namespace testbed
