// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree find`: the moments of a session that matter: a body that went through a wall, two in each other, a step that
// took long.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "testbed/base/errors.h"
#include "testbed/base/new_file.h"
#include "testbed/base/output.h"
#include "testbed/base/progress.h"
#include "testbed/base/temporary_folder.h"
#include "testbed/base/text.h"
#include "testbed/jobs/find/commands.h"
#include "testbed/jobs/find/report.h"
#include "testbed/options/condition_options.h"
#include "testbed/options/options.h"
#include "testbed/options/session.h"
#include "testbed/picture/png.h"
#include "testbed/view/camera.h"
#include "testbed/view/picture.h"

namespace testbed {

namespace {

/// Moments that are printed and drawn; files hold all.
constexpr std::size_t mostShown = 50, mostPictures = 20;

struct FindArguments {
    SessionArguments session;
    ConditionArguments conditions;
    std::string pictures, json, junit, page, timeline;
};

/// Metres across a picture of all that moves and what is near it.
double AcrossAll(const Snapshot& snapshot, const PictureOptions& options) {
    FitArea area;
    const Snapshot* const snapshots[] = {&snapshot};
    AddStep(area, snapshots);
    return options.width / FitCamera(GetFitBoxes(area), options.width, options.height, {}).pixelsPerMetre;
}

/// Whether a picture this wide shows something of another body; with `isStatic`, of a static one.
bool ShowsOthers(const Snapshot& snapshot, const Moment& moment, Vec2 middle, double across,
                 const PictureOptions& options, bool isStatic) {
    const auto x = static_cast<float>(across / 2), y = static_cast<float>(across / 2 * options.height / options.width);
    const Box view{{middle.x - x, middle.y - y}, {middle.x + x, middle.y + y}};
    return std::ranges::any_of(snapshot.fixtures, [&](const FixtureState& fixture) {
        const BodyState& body = snapshot.bodies[static_cast<std::size_t>(fixture.body)];
        const bool isOther = std::ranges::find(moment.bodies, body.index) == moment.bodies.end();
        const bool isMeant = isOther && (!isStatic || body.type == scenes::BodyType::isStatic);
        return isMeant && Overlaps(fixture.tight, view);
    });
}

/// Around the bodies of a moment, several times their size. If they would be alone, so wide that some of the level is
/// there, too. Everything if they are nowhere.
std::optional<Camera> CameraFor(const Snapshot& snapshot, const Moment& moment, const PictureOptions& options) {
    std::optional<Box> around;
    for (const FixtureState& fixture : snapshot.fixtures) {
        const BodyState& body = snapshot.bodies[static_cast<std::size_t>(fixture.body)];
        // A level is not what a moment is about.
        const bool isMeant = std::ranges::find(moment.bodies, body.index) != moment.bodies.end() &&
                             body.type != scenes::BodyType::isStatic;
        if (!isMeant) continue;
        if (!around) around = fixture.tight;
        around->lower = {std::min(around->lower.x, fixture.tight.lower.x),
                         std::min(around->lower.y, fixture.tight.lower.y)};
        around->upper = {std::max(around->upper.x, fixture.tight.upper.x),
                         std::max(around->upper.y, fixture.tight.upper.y)};
    }
    if (!around) return std::nullopt;
    const double width = double{around->upper.x} - around->lower.x, height = double{around->upper.y} - around->lower.y;
    const double all = AcrossAll(snapshot, options);
    double across = std::max(8.0 * std::max(width, height), all / 6.0);
    if (!std::isfinite(across) || across <= 0.0) return std::nullopt;
    const double x = around->lower.x + width / 2, y = around->lower.y + height / 2;
    const Vec2 middle{static_cast<float>(x), static_cast<float>(y)};
    const double widest = ShowsOthers(snapshot, moment, middle, across, options, false) ? 0.0 : 3.0 * all;
    while (across < widest && !ShowsOthers(snapshot, moment, middle, across / 1.25, options, true)) across *= 1.25;
    return MakeCamera({x, y, across}, options.width, options.height);
}

/// Goes through the session again and draws what was found.
void DrawMoments(Session session, FindReport& report, const std::string& folder) {
    OutputFolder output(folder);
    PictureMaker maker(Backend::cpu);
    PictureOptions options;
    options.width = 960;
    options.height = 540;
    options.layers = ParseLayers("bodies,contacts,normals,velocities,joints");
    std::size_t drawn = 0;
    for (FoundMoment& found : report.found) {
        if (drawn == mostPictures) break;
        while (session.GetStep() < found.moment.step && session.Step()) {
        }
        const Snapshot snapshot = session.Capture();
        const PaneInput pane{&snapshot, found.moment.condition};
        const Image image = maker.MakeRender(pane, options, CameraFor(snapshot, found.moment, options));
        const std::string name =
            fmt::format("{:02}-{}-step-{:04}.png", ++drawn, found.moment.condition, found.moment.step);
        output.WriteBy(name, [&](const std::filesystem::path& place) { WritePng(place, image); });
        found.picture = (std::filesystem::path(folder) / name).string();
    }
}

/// The page; its pictures are inside, so that they need no folder that stays.
void WritePageOf(const FindReport& report, const Session& session, const FindArguments& arguments,
                 const SceneInput& input) {
    if (!arguments.pictures.empty()) return WriteFindPage(arguments.page, report, session);
    const TemporaryFolder folder("scree-find");
    FindReport drawn = report;
    DrawMoments(OpenSession(arguments.session, input), drawn, folder.GetPath().string());
    WriteFindPage(arguments.page, drawn, session);
}

/// Refuses a link into nothing before the work.
void CheckTimeline(const FindArguments& arguments) {
    if (arguments.timeline.empty() || std::filesystem::exists(arguments.timeline)) return;
    throw UsageError(fmt::format("--timeline {}: there is no such file; `scree timeline {} -o {}` makes it",
                                 arguments.timeline, QuoteForShell(arguments.session.input),
                                 QuoteForShell(arguments.timeline)));
}

void Look(Session& session, Watch& watch) {
    Progress progress("find", std::max(1, session.GetLastStep() - session.GetStep()));
    while (session.Step()) {
        watch.Show(session.Capture(), session.GetTimeStep());
        progress.Advance(1);
    }
}

int RunFind(const FindArguments& arguments, const Request& request) {
    CheckTimeline(arguments);
    const SceneInput input = ChooseSessionInput(arguments.session);
    Session session = OpenSession(arguments.session, input);
    for (const std::string& file : {arguments.page, arguments.json, arguments.junit}) CheckCanWrite(file);
    AskedConditions asked = MakeConditions(arguments.conditions, arguments.session, input, session);

    FindReport report{
        .input = arguments.session.input, .command = DescribeCommand(request.arguments), .conditions = asked.names};
    const int first = session.GetStep();
    Watch watch(session.GetScene(), std::move(asked.conditions), session.GetTime());
    watch.Show(session.Capture(), 0.0);
    Look(session, watch);
    report.steps = session.GetStep() - first;
    for (Moment& moment : watch.Finish()) report.found.push_back({std::move(moment)});
    report.timeline = arguments.timeline;
    for (FoundMoment& found : report.found) {
        if (!arguments.timeline.empty()) found.link = LinkTo(arguments.timeline, found.moment);
    }
    if (!arguments.pictures.empty()) {
        DrawMoments(OpenSession(arguments.session, input), report, arguments.pictures);
    }
    if (!arguments.page.empty()) WritePageOf(report, session, arguments, input);
    if (!arguments.json.empty()) WriteTextFile(arguments.json, WriteFindJson(report, session));
    if (!arguments.junit.empty()) WriteTextFile(arguments.junit, WriteFindJUnit(report, session));
    for (std::size_t i = 0; i < std::min(report.found.size(), mostShown); ++i) {
        fmt::print("{}\n", DescribeMoment(report.found[i], session));
    }
    if (report.found.size() > mostShown) fmt::print("and {} more\n", report.found.size() - mostShown);
    fmt::print("{}\n", Summarize(report));
    return report.found.empty() ? exitDone : exitDiffers;
}

}  // namespace

void AddFindCommand(CLI::App& app, Request& request) {
    CLI::App* command = app.add_subcommand(
        "find", "The moments of a session that matter: tunnelling, overlap, spikes; exit code 1 if there are any");
    auto arguments = std::make_shared<FindArguments>();
    AddSessionOptions(*command, arguments->session);
    AddConditionOptions(*command, arguments->conditions);
    command->add_option("--pictures", arguments->pictures, "Folder for a picture of each of the first 20 moments")
        ->type_name("DIR");
    command->add_option("--page", arguments->page, "The moments as a page, with the first 20 pictures inside")
        ->type_name("FILE");
    command
        ->add_option("--timeline", arguments->timeline,
                     "A page that `scree timeline` made of the same session: each moment gets a link into it")
        ->type_name("FILE");
    command->add_option("--json", arguments->json, "The moments as JSON")->type_name("FILE");
    command->add_option("--junit", arguments->junit, "One JUnit test case per condition, for CI")->type_name("FILE");
    command->callback(
        [&request, arguments] { request.action = [&request, arguments] { return RunFind(*arguments, request); }; });
}

}  // namespace testbed
