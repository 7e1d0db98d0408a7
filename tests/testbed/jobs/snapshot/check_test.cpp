// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `snapshot check` and `update` on references of their own: every kind of difference is found and named, and a changed
// engine or scene does not pass.

#include "testbed/jobs/snapshot/check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "testbed/base/errors.h"
#include "testbed/jobs/snapshot/reference_folder.h"
#include "testbed/jobs/snapshot/report.h"
#include "testbed/picture/png.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Pictures of one small scene in a folder of its own; the CPU draws them.
class SnapshotCheck : public testing::Test {
protected:
    SnapshotCheck() : m_maker(Backend::cpu) {
        m_job.references = m_scratch.GetPath() / "references";
        m_job.report = m_scratch.GetPath() / "report";
        m_job.catalog = GetSnapshotCatalog();
        m_job.pattern = "^friction-row/";
        m_job.update = UpdateMode::all;
        const SnapshotOutcome first = CheckSnapshots(m_job, m_maker);
        m_ids = first.rewritten;
        m_job.update = UpdateMode::none;
    }

    SnapshotOutcome Check() { return CheckSnapshots(m_job, m_maker); }
    /// The result of the scene's last picture, all others being equal.
    SnapshotResult CheckLast() {
        SnapshotOutcome outcome = Check();
        for (std::size_t i = 0; i + 1 < outcome.results.size(); ++i) {
            EXPECT_EQ(outcome.results[i].status, SnapshotStatus::equal) << outcome.results[i].message;
        }
        return outcome.results.back();
    }
    [[nodiscard]] fs::path Picture() const { return m_job.references / (m_ids.back() + ".png"); }
    [[nodiscard]] fs::path Sidecar() const { return m_job.references / (m_ids.back() + ".json"); }
    void AddRule(const std::string& rule) const {
        Json sidecar = Json::parse(std::ifstream(Sidecar()));
        sidecar["compare"] = Json::parse(rule);
        std::ofstream(Sidecar()) << sidecar;
    }
    void ChangePixels(int count, int by) const {
        Image image = ReadPng(Picture());
        for (int x = 0; x < count; ++x) image.At(200 + x, 150).r = static_cast<uint8_t>(image.At(200 + x, 150).r + by);
        WritePng(Picture(), image);
    }
    [[nodiscard]] Json ReadResults() const { return Json::parse(std::ifstream(m_job.report / "results.json")); }

    ScratchFolder m_scratch;
    SnapshotJob m_job;
    PictureMaker m_maker;
    std::vector<std::string> m_ids;
};

TEST_F(SnapshotCheck, IsCleanRightAfterAnUpdateAndLeavesNoReport) {
    EXPECT_EQ(m_ids.size(), SelectCases(m_job.catalog, m_job.pattern).size());
    const SnapshotOutcome outcome = Check();
    EXPECT_EQ(outcome.results.size(), m_ids.size());
    EXPECT_TRUE(IsClean(outcome.results));
    EXPECT_EQ(outcome.structureOnly, 0);
    EXPECT_FALSE(fs::exists(m_job.report));
}

TEST_F(SnapshotCheck, TwoChangedPixelsAreCountedBoundedAndPictured) {
    ChangePixels(2, 40);
    const SnapshotResult result = CheckLast();
    EXPECT_EQ(result.status, SnapshotStatus::changed);
    EXPECT_EQ(result.pixels.changed, 2);
    EXPECT_EQ(result.pixels.maxDifference, 40);
    EXPECT_EQ(result.pixels.box, (PixelArea{200, 150, 202, 151}));
    EXPECT_TRUE(result.structure.empty()) << "the state did not change";
    const Json entry = ReadResults()["results"].back();
    EXPECT_EQ(entry["status"], "changed");
    for (const std::string path : {entry["expected"]["image"], entry["actual"]["image"], entry["difference"],
                                   entry["expected"]["sidecar"], entry["actual"]["sidecar"]}) {
        EXPECT_TRUE(fs::exists(m_job.report / path)) << path;
    }
}

TEST_F(SnapshotCheck, AMissingReferenceFailsAndIsLeftInActual) {
    fs::remove(Picture());
    fs::remove(Sidecar());
    const SnapshotResult result = CheckLast();
    EXPECT_EQ(result.status, SnapshotStatus::missing);
    EXPECT_TRUE(fs::exists(m_job.report / "actual" / (result.id + ".png")));
    EXPECT_EQ(result.update, "testbed/run snapshot update --update missing -g '^" + result.id + "$'");
}

TEST_F(SnapshotCheck, AnotherSizeALostFileAndADamagedFileAreEachNamed) {
    WritePng(Picture(), Image(64, 64, Color{1, 2, 3, 255}));
    EXPECT_EQ(CheckLast().status, SnapshotStatus::size);
    fs::remove(Picture());
    EXPECT_EQ(CheckLast().status, SnapshotStatus::deleted);
    std::ofstream(Picture()) << "no picture";
    EXPECT_EQ(CheckLast().status, SnapshotStatus::failed);
}

TEST_F(SnapshotCheck, AReferenceThatNobodyMakesIsAnOrphanUntilAllIsUpdated) {
    const std::string orphan = "friction-row/step-9999-gone";
    std::ofstream(m_job.references / (orphan + ".json")) << "{}";
    SnapshotOutcome outcome = Check();
    EXPECT_EQ(outcome.results.back().id, orphan);
    EXPECT_EQ(outcome.results.back().status, SnapshotStatus::orphan);
    EXPECT_EQ(outcome.caseCount, m_ids.size() + 1);
    m_job.update = UpdateMode::changed;
    EXPECT_FALSE(IsClean(Check().results));
    m_job.update = UpdateMode::all;
    outcome = Check();
    EXPECT_EQ(outcome.removed, std::vector<std::string>{orphan});
    EXPECT_TRUE(IsClean(outcome.results));
}

TEST_F(SnapshotCheck, UpdateRewritesOnlyTheKindAskedFor) {
    ChangePixels(1, 1);
    fs::remove(m_job.references / (m_ids.front() + ".png"));
    fs::remove(m_job.references / (m_ids.front() + ".json"));
    m_job.update = UpdateMode::missing;
    EXPECT_EQ(Check().rewritten, std::vector<std::string>{m_ids.front()});
    m_job.update = UpdateMode::changed;
    EXPECT_EQ(Check().rewritten, std::vector<std::string>{m_ids.back()});
    m_job.update = UpdateMode::all;
    EXPECT_TRUE(Check().rewritten.empty());
}

TEST_F(SnapshotCheck, ToleranceAndMaskApplyAreNamedAndSurviveAnUpdate) {
    AddRule(R"({"tolerance": 3, "mask": [[200, 150, 202, 151]], "reason": "a test"})");
    ChangePixels(2, 100);
    SnapshotResult result = CheckLast();
    EXPECT_EQ(result.status, SnapshotStatus::equal);
    EXPECT_EQ(result.pixels.masked, 2);
    EXPECT_NE(result.message.find(m_ids.back() + ".json: a test"), std::string::npos) << result.message;
    ChangePixels(3, 3);
    result = CheckLast();
    EXPECT_EQ(result.status, SnapshotStatus::equal);
    EXPECT_EQ(result.pixels.tolerated, 1);
    ChangePixels(3, 1);
    EXPECT_EQ(CheckLast().status, SnapshotStatus::changed);
    m_job.update = UpdateMode::changed;
    (void)Check();
    EXPECT_EQ(ReadReference(m_job.references, m_ids.back()).rule.tolerance, 3);
}

TEST_F(SnapshotCheck, ABadRuleFailsInsteadOfBeingIgnored) {
    for (const char* rule : {R"({"tolerance": 3})", R"({"tolerance": 256, "reason": "x"})", R"({"tolerence": 1})",
                             R"({"mask": [[3, 3, 3, 4]], "reason": "x"})", "7"}) {
        AddRule(rule);
        EXPECT_EQ(CheckLast().status, SnapshotStatus::failed) << rule;
    }
}

// The whole pipeline: a constant of the world off by half a per cent must reach the pixels.
TEST_F(SnapshotCheck, AGravityThatIsSlightlyOffIsCaught) {
    m_job.making.perturb = [](scenes::Scene& scene) { scene.gravity.y *= 1.005f; };
    const SnapshotOutcome outcome = Check();
    EXPECT_EQ(outcome.results.back().status, SnapshotStatus::changed) << outcome.results.back().message;
    const Json structure = Json::parse(outcome.results.back().structure);
    EXPECT_FALSE(structure["equal"].get<bool>());
    EXPECT_GT(structure["bodies"]["changed"].get<int>(), 0);
    const Json first = structure["bodies"]["list"][0];
    EXPECT_NE(first["expected"], first["actual"]);
}

TEST_F(SnapshotCheck, AFrictionThatIsSlightlyOffIsCaught) {
    m_job.making.perturb = [](scenes::Scene& scene) {
        for (scenes::Fixture& fixture : scene.fixtures) fixture.friction *= 0.98f;
    };
    EXPECT_FALSE(IsClean(Check().results));
}

TEST_F(SnapshotCheck, FewerSolverIterationsAreCaught) {
    m_job.making.perturb = [](scenes::Scene& scene) { scene.velocityIterations = 1; };
    const SnapshotOutcome outcome = Check();
    EXPECT_TRUE(!IsClean(outcome.results) || outcome.structureOnly > 0);
}

TEST_F(SnapshotCheck, JunitAndAnnotationsSpeakOfEveryDifferenceOnce) {
    ChangePixels(1, 9);
    const SnapshotOutcome outcome = Check();
    const std::string junit = WriteJunit("snapshots <a&b>", outcome.results);
    EXPECT_NE(
        junit.find("name=\"snapshots &lt;a&amp;b&gt;\" tests=\"" + std::to_string(m_ids.size()) + "\" failures=\"1\""),
        std::string::npos)
        << junit;
    EXPECT_NE(junit.find("-g &apos;^" + m_ids.back()), std::string::npos) << junit;
    const std::string annotations = FormatAnnotations(outcome.results, "tests/snapshots");
    EXPECT_TRUE(
        annotations.starts_with("::error file=tests/snapshots/" + m_ids.back() + ".png,title=snapshot changed::"))
        << annotations;
    EXPECT_EQ(std::count(annotations.begin(), annotations.end(), '\n'), 1);
}

TEST_F(SnapshotCheck, RefusesABadExpressionAndOneThatMatchesNothing) {
    m_job.pattern = "(";
    EXPECT_THROW((void)Check(), UsageError);
    m_job.pattern = "no-such-scene";
    EXPECT_THROW((void)Check(), UsageError);
}

}  // namespace
}  // namespace testbed
