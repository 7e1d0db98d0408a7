// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Every scene gives the same state hash after every step with everything on, with what it uses, and with the fixed set
// of what it uses. That holds with both solvers. In many scenes what it uses takes smaller kernels.

#include <gtest/gtest.h>

#include <map>

#include "scenes/catalog.h"
#include "testbed/jobs/requires/ablation.h"
#include "testbed/jobs/requires/break_even.h"
#include "testbed/jobs/requires/requirement.h"
#include "tests/determinism/small_scenes.h"

namespace testbed {
namespace {

TEST(Features, EverySceneGivesTheSameBitsWithoutWhatItDoesNotUse) {
    int smaller = 0;
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        const scenes::Scene scene = determinism::BuildSmall(info);
        for (const int substeps : {0, 4}) {
            RequirementTask task{.spec = {}, .steps = 60, .repeats = 1};
            if (substeps > 0) task.spec.solver = SoftStep{substeps};
            const Requirement r = MeasureRequirement(scene, task);
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
    RunSpec spec = MakeSpec("scree", likeBox2dPreset);
    spec.features = "rotation+sleeping+polygons+edges+speedLimit";
    EXPECT_THROW(MakeRun(scene, spec), std::invalid_argument);
    spec.features = "rotation+wings";
    EXPECT_THROW(MakeRun(scene, spec), std::invalid_argument);
    spec.features = "rotation+sleeping+polygons+edges+speedLimit+friction";
    EXPECT_NO_THROW(MakeRun(scene, spec)->Step());
}

TEST(Features, AnAblationHasARowPerFeatureAndLeavesOutOnlyWhatIsNotUsed) {
    const scenes::Scene scene = scenes::Build("slow-explosion", 30);
    RequirementTask task{.spec = {}, .steps = 5, .repeats = 2};
    task.spec.continuous = false;
    const std::vector<AblationRow> rows = MeasureAblation(scene, task);
    const std::vector<FeatureUse> uses = FindUses(scene, task);
    ASSERT_EQ(rows.size(), uses.size() + 2);  // and two kernels of several features
    std::map<std::string, AblationRow> byName;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i < uses.size()) {
            EXPECT_EQ(rows[i].feature, uses[i].name);
        }
        EXPECT_EQ(rows[i].full.nsPerBodyStep > 0.0, rows[i].users == 0) << rows[i].feature;
        EXPECT_EQ(rows[i].without.nsPerBodyStep > 0.0, rows[i].users == 0) << rows[i].feature;
        EXPECT_TRUE(rows[i].without.sameHash) << rows[i].feature;
        byName[rows[i].feature] = rows[i];
    }
    // One of three keeps the kernel and its column of 16 bytes a body; all three together take it away.
    EXPECT_EQ(byName.at("damping").kernel, FeatureKernel::shared);
    EXPECT_EQ(byName.at("damping").GetBytesChange(), 0);
    EXPECT_EQ(byName.at("damping").without.kernels, byName.at("damping").full.kernels);
    const AblationRow& together = byName.at("damping, gravityScale, forces");
    EXPECT_EQ(together.kernel, FeatureKernel::own);
    EXPECT_EQ(together.GetBytesChange(), -16);
    EXPECT_NE(together.without.kernels, together.full.kernels);
    EXPECT_NE(byName.at("speedLimit").without.kernels, byName.at("speedLimit").full.kernels);
    EXPECT_EQ(byName.at("springs").kernel, FeatureKernel::none);
    const std::string csv = MakeAblationCsv(rows);
    EXPECT_NE(csv.find("slow-explosion,30,damping,shared,0,"), std::string::npos);
    EXPECT_NE(csv.find("slow-explosion,30,\"damping, gravityScale, forces\",own,0,"), std::string::npos);
}

TEST(Features, BreakEvenIsWhereAPartBeginsToPayForGood) {
    EXPECT_EQ(DescribeBreakEven({{0.0, 10, 11}, {0.2, 10, 9}, {0.4, 10, 12}, {0.6, 10, 8}, {1.0, 10, 5}}),
              "pays above a share of 0.50; saves 50 % at 1.00");
    EXPECT_EQ(DescribeBreakEven({{0.0, 10, 9}, {1.0, 10, 5}}), "pays at every share; saves 50 % at 1.00");
    EXPECT_EQ(DescribeBreakEven({{0.0, 10, 9}, {0.5, 10, 11}}), "costs 10 % at 0.50");
    EXPECT_EQ(DescribeBreakEven({}), "");
}

TEST(Features, PathsOfIsolatedBodiesAreMeasuredOnTheWorldsThatTheyAreMadeFor) {
    const BreakEvenPlan plan{.movers = 50, .steps = 3, .repeats = 1, .shares = {0.0, 0.5, 1.0}};
    for (const int substeps : {0, 4}) {
        const std::vector<BreakEvenPoint> points = MeasureIsolatedShare(plan, substeps);
        ASSERT_EQ(points.size(), 3u);
        for (const BreakEvenPoint& point : points) EXPECT_TRUE(point.nsWith > 0.0 && point.nsWithout > 0.0);
    }
}

TEST(Features, TheHeaderNamesWhatTheSceneUses) {
    Requirement r{"two-words", 3, 10, {{"rotation", 2}, {"friction", 0}, {"joints", 1}}, {}};
    EXPECT_EQ(r.GetMinimalSet(), "rotation+joints");
    const std::string header = MakeFeatureHeader(r, "scree requires two-words");
    EXPECT_NE(header.find("inline constexpr scree::Features two_words_features{scree::Feature::rotation, "
                          "scree::Feature::joints};"),
              std::string::npos)
        << header;
    EXPECT_NE(header.find("-DSCREE_FEATURES=\"rotation;joints\""), std::string::npos);
}

}  // namespace
}  // namespace testbed
