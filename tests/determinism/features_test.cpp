// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Every scene gives the same state hash after every step with everything on, with what it uses, and with the fixed set
// of what it uses, with both solvers; in many scenes that takes smaller kernels.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "scenes/catalog.h"
#include "testbed/report/ablation.h"
#include "testbed/report/requirement.h"

namespace testbed {
namespace {

/// Small enough that all scenes run in seconds.
int SmallSize(const scenes::SceneInfo& info) {
    static const std::map<std::string_view, int> sizes = {{"tiles", 15},
                                                          {"falling-squares", 8},
                                                          {"falling-circles", 8},
                                                          {"multi-fixture", 4},
                                                          {"add-pair", 150},
                                                          {"mild-n2", 4},
                                                          {"n2", 25},
                                                          {"mostly-static-single", 8},
                                                          {"diagonal", 3},
                                                          {"mixed", 200},
                                                          {"mostly-static-multi", 8},
                                                          {"slow-explosion", 300},
                                                          {"big-mobile", 5},
                                                          {"pyramid", 8},
                                                          {"tumbler", 50}};
    const auto found = sizes.find(info.name);
    if (!info.hasSize || found == sizes.end())
        return info.hasSize ? std::max(info.minSize, std::min(info.defaultSize, 6)) : 0;
    return found->second;
}

scenes::Scene BuildSmall(const scenes::SceneInfo& info) {
    return info.hasSize ? scenes::Build(info.name, SmallSize(info)) : scenes::Build(info.name);
}

TEST(Features, EverySceneGivesTheSameBitsWithoutWhatItDoesNotUse) {
    int smaller = 0;
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        const scenes::Scene scene = BuildSmall(info);
        for (const int substeps : {0, 4}) {
            const RequirementPlan plan{.steps = 60, .repeats = 1, .substeps = substeps, .continuous = true};
            const Requirement r = MeasureRequirement(scene, plan);
            for (const VariantCost& v : r.variants) {
                EXPECT_TRUE(v.sameHash) << info.name << ", " << v.name << ", sub-steps " << substeps << ", step "
                                        << v.firstDifference;
            }
            EXPECT_EQ(r.variants[1].kernels, r.variants[2].kernels) << info.name;
            if (substeps == 0) smaller += r.variants[0].kernels != r.variants[2].kernels ? 1 : 0;
        }
    }
    std::printf("smaller kernels than full in %d scenes\n", smaller);
    EXPECT_GE(smaller, 10);
}

TEST(Features, LeavingOutWhatASceneUsesIsRefused) {
    const scenes::Scene scene = scenes::Build("pyramid", 4);
    RunOptions options;
    options.features = "rotation,sleeping,polygons,edges,speedLimit";
    EXPECT_THROW(MakeScreeRun(scene, options), std::invalid_argument);
    options.features = "rotation,wings";
    EXPECT_THROW(MakeScreeRun(scene, options), std::invalid_argument);
    options.features = "rotation,sleeping,polygons,edges,speedLimit,friction";
    EXPECT_NO_THROW(MakeScreeRun(scene, options)->Step());
}

TEST(Features, AnAblationHasARowPerFeatureAndLeavesOutOnlyWhatIsNotUsed) {
    const scenes::Scene scene = scenes::Build("slow-explosion", 30);
    const RequirementPlan plan{.steps = 5, .repeats = 2};
    const std::vector<AblationRow> rows = MeasureAblation(scene, plan);
    ASSERT_EQ(rows.size(), FindUses(scene, plan).size());
    for (const AblationRow& row : rows) {
        EXPECT_EQ(row.leftOut.empty(), row.users > 0) << row.feature;
        EXPECT_TRUE(row.without.sameHash) << row.feature;
    }
    EXPECT_NE(MakeAblationCsv(rows).find("slow-explosion,30,damping,0,\"damping, gravityScale, forces\",yes,"),
              std::string::npos);
}

TEST(Features, TheHeaderNamesWhatTheSceneUses) {
    Requirement r{"two-words", 3, 10, {{"rotation", 2}, {"friction", 0}, {"joints", 1}}, {}};
    EXPECT_EQ(r.GetMinimalSet(), "rotation,joints");
    const std::string header = MakeFeatureHeader(r, "scree requires two-words");
    EXPECT_NE(header.find("inline constexpr scree::Features two_words_features{scree::Feature::rotation, "
                          "scree::Feature::joints};"),
              std::string::npos)
        << header;
    EXPECT_NE(header.find("-DSCREE_FEATURES=\"rotation;joints\""), std::string::npos);
}

}  // namespace
}  // namespace testbed
