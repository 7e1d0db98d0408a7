// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree find`: the moments of a session that matter: a body that went through a wall, two in each other, a step that
// took long.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "testbed/base/errors.h"
#include "testbed/base/new_file.h"
#include "testbed/base/output.h"
#include "testbed/base/text.h"
#include "testbed/jobs/find/commands.h"
#include "testbed/jobs/find/report.h"
#include "testbed/moments/conditions.h"
#include "testbed/options/options.h"
#include "testbed/options/session.h"
#include "testbed/picture/png.h"
#include "testbed/view/picture.h"

namespace testbed {

namespace {

/// Moments that are printed and drawn; files hold all.
constexpr std::size_t mostShown = 50, mostPictures = 20;

struct FindArguments {
    SessionArguments session;
    std::optional<int> pileOn;
    bool tunnel = false, nonFinite = false, jitter = false;
    std::optional<double> overlap, speed, spin, spike, jointGap, awake;
    std::string escape, diverge;
    std::vector<std::string> when;
    double longer = 0, distance = 0;
    std::string pictures, json, junit;
};

Box ParseBox(const std::string& text) {
    std::vector<float> numbers;
    for (const std::string_view part : Split(text, ',')) {
        const Parsed<double> number = ParseNumber<double>(part);
        if (!number) break;
        numbers.push_back(static_cast<float>(*number));
    }
    if (numbers.size() != 4 || numbers[0] > numbers[2] || numbers[1] > numbers[3]) {
        throw UsageError(
            fmt::format("--escape {}: give left,bottom,right,top in metres, for example --escape=-20,-1,20,30", text));
    }
    return {{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
}

/// The other side of --diverge: a file, or an engine that runs the same.
struct Other {
    std::unique_ptr<Session> session;
    Snapshot state;

    const Snapshot* After(int step) {
        while (session->GetStep() < step) {
            if (!session->Step()) return nullptr;
        }
        state = session->Capture();
        return &state;
    }
};

std::shared_ptr<Other> MakeOther(const FindArguments& arguments, const SceneInput& input) {
    auto other = std::make_shared<Other>();
    SessionArguments there = arguments.session;
    if (LooksLikeFile(arguments.diverge)) {
        there.input = arguments.diverge;
        there.size.reset();
        other->session = std::make_unique<Session>(OpenSession(there, ChooseSessionInput(there)));
        return other;
    }
    if (input.motion != nullptr) {
        throw UsageError(
            fmt::format("--diverge {}: {} is a motion, and --from K says where an engine starts in it; "
                        "give another file",
                        arguments.diverge, there.input));
    }
    there.engine = arguments.diverge;
    other->session = std::make_unique<Session>(OpenSession(there, input));
    return other;
}

/// Conditions with the names by which they are asked for.
struct Asked {
    std::vector<std::string> names;
    Conditions conditions;
    bool needsContacts = false, needsTimes = false;

    void Add(const std::string& name, std::unique_ptr<Condition> condition) {
        names.push_back(name);
        conditions.push_back(std::move(condition));
    }
};

/// Expressions, numbered where there are several.
void AddExpressions(const std::vector<std::string>& texts, const Session& session, Asked& asked) {
    for (std::size_t i = 0; i < texts.size(); ++i) {
        try {
            Expression expression(texts[i], session.GetNames());
            asked.needsContacts = asked.needsContacts || expression.NeedsContacts();
            const std::string name = texts.size() == 1 ? "when" : fmt::format("when-{}", i + 1);
            asked.Add(name, MakeWhenCondition(name, std::move(expression)));
        } catch (const UsageError& error) {
            throw UsageError(fmt::format("--when '{}': {}", texts[i], error.what()));
        }
    }
}

Asked MakeConditions(const FindArguments& a, const SceneInput& input, const Session& session) {
    Asked asked;
    asked.needsContacts = a.overlap || a.pileOn;
    asked.needsTimes = a.spike.has_value();
    if (a.tunnel) asked.Add("tunnel", MakeTunnelCondition());
    if (a.overlap) asked.Add("overlap", MakeOverlapCondition(*a.overlap, a.longer));
    if (a.speed) asked.Add("speed", MakeSpeedCondition(*a.speed));
    if (a.spin) asked.Add("spin", MakeSpinCondition(*a.spin));
    if (a.nonFinite) asked.Add("non-finite", MakeNonFiniteCondition());
    if (!a.escape.empty()) asked.Add("escape", MakeEscapeCondition(ParseBox(a.escape)));
    if (a.spike) asked.Add("spike", MakeSpikeCondition(*a.spike));
    if (a.jointGap) asked.Add("joint-gap", MakeJointGapCondition(*a.jointGap));
    if (a.jitter) asked.Add("jitter", MakeJitterCondition());
    if (a.awake) asked.Add("awake", MakeAwakeCondition(*a.awake));
    if (a.pileOn) asked.Add("pile-on", MakePileOnCondition(*a.pileOn));
    if (!a.diverge.empty()) {
        asked.Add("diverge", MakeDivergeCondition(
                                 a.distance, [other = MakeOther(a, input)](int step) { return other->After(step); }));
    }
    AddExpressions(a.when, session, asked);
    if (asked.names.empty()) {
        asked.Add("tunnel", MakeTunnelCondition());
        asked.Add("non-finite", MakeNonFiniteCondition());
    }
    return asked;
}

void CheckHas(const Session& session, const Asked& asked, const std::string& input) {
    constexpr const char* cure = "record it with scree_capture::Options::{} = true, or give --from K to run an engine";
    if (asked.needsContacts && !session.HasContacts()) {
        throw UsageError(
            fmt::format("{} was recorded without contacts, which --overlap, --pile-on and contacts in --when need; {}",
                        input, fmt::format(fmt::runtime(cure), "contacts")));
    }
    if (asked.needsTimes && !session.HasTimes()) {
        throw UsageError(fmt::format("{} was recorded without times, which --spike needs; {}", input,
                                     fmt::format(fmt::runtime(cure), "stages")));
    }
}

/// Around the bodies of a moment, several times their size; everything if they are nowhere.
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
    const double across = 8.0 * std::max(width, height);
    if (!std::isfinite(across) || across <= 0.0) return std::nullopt;
    return MakeCamera({around->lower.x + width / 2, around->lower.y + height / 2, across}, options.width,
                      options.height);
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

int RunFind(const FindArguments& arguments, const Request& request) {
    const SceneInput input = ChooseSessionInput(arguments.session);
    Session session = OpenSession(arguments.session, input);
    Asked asked = MakeConditions(arguments, input, session);
    CheckHas(session, asked, arguments.session.input);

    FindReport report{
        .input = arguments.session.input, .command = DescribeCommand(request.arguments), .conditions = asked.names};
    const int first = session.GetStep();
    Watch watch(session.GetScene(), std::move(asked.conditions));
    watch.Show(session.Capture(), 0.0);
    while (session.Step()) watch.Show(session.Capture(), session.GetTimeStep());
    report.steps = session.GetStep() - first;
    for (Moment& moment : watch.Finish()) report.found.push_back({std::move(moment)});
    if (!arguments.pictures.empty()) {
        DrawMoments(OpenSession(arguments.session, input), report, arguments.pictures);
    }
    if (!arguments.json.empty()) WriteTextFile(arguments.json, WriteFindJson(report, session));
    if (!arguments.junit.empty()) WriteTextFile(arguments.junit, WriteFindJUnit(report, session));
    for (std::size_t i = 0; i < std::min(report.found.size(), mostShown); ++i) {
        fmt::print("{}\n", DescribeMoment(report.found[i], session));
    }
    if (report.found.size() > mostShown) fmt::print("and {} more\n", report.found.size() - mostShown);
    fmt::print("{} moments in {} steps: {}\n", report.found.size(), report.steps, fmt::join(report.conditions, ", "));
    return report.found.empty() ? exitDone : exitDiffers;
}

void AddConditions(CLI::App& app, FindArguments& a) {
    const char* group = "Conditions (tunnel and non-finite if none is given)";
    const auto number = [&](const char* name, std::optional<double>& value, const char* what, const char* type) {
        app.add_option(name, value, what)->type_name(type)->check(CLI::NonNegativeNumber)->group(group);
    };
    app.add_flag("--tunnel", a.tunnel, "A body that went through a static shape and was not pushed out")->group(group);
    number("--overlap", a.overlap, "Two bodies deeper in each other than this, m", "M");
    app.add_option("--longer", a.longer, "With --overlap: for longer than this, s")
        ->check(CLI::NonNegativeNumber)
        ->group(group);
    number("--speed", a.speed, "A body faster than this, m/s", "V");
    number("--spin", a.spin, "A body that turns faster than this, rad/s", "W");
    app.add_flag("--non-finite", a.nonFinite, "A body whose pose or velocity is no number")->group(group);
    app.add_option("--escape", a.escape, "A body that leaves the box left,bottom,right,top: --escape=-20,-1,20,30")
        ->type_name("BOX")
        ->group(group);
    number("--spike", a.spike, "A step that takes this many times the median", "F");
    number("--joint-gap", a.jointGap, "A revolute or weld joint open by more than this, m", "M");
    app.add_flag("--jitter", a.jitter, "A body that stays where it is and yet shakes")->group(group);
    number("--awake", a.awake, "A body that is awake for longer than this and goes nowhere, s", "S");
    app.add_option("--pile-on", a.pileOn, "A body that moves, with more than this many contacts")
        ->type_name("N")
        ->check(CLI::NonNegativeNumber)
        ->group(group);
    app.add_option("--when", a.when,
                   "Steps after which this holds, by names or indices of bodies: 'body(\"player\").y < -5 and not "
                   "body(\"player\").awake', 'contacts(\"player\", \"lava\") > 0'; repeatable")
        ->type_name("EXPR")
        ->allow_extra_args(false)
        ->group(group);
    app.add_option("--diverge", a.diverge, "The first step that differs from that of another file or engine")
        ->type_name("FILE|ENGINE[:KEY=VALUE]")
        ->group(group);
    app.add_option("--distance", a.distance, "With --diverge: a difference is more than this, m; 0: any bit")
        ->check(CLI::NonNegativeNumber)
        ->group(group);
}

}  // namespace

void AddFindCommand(CLI::App& app, Request& request) {
    CLI::App* command = app.add_subcommand(
        "find", "The moments of a session that matter: tunnelling, overlap, spikes; exit code 1 if there are any");
    auto arguments = std::make_shared<FindArguments>();
    AddSessionOptions(*command, arguments->session);
    AddConditions(*command, *arguments);
    command->add_option("--pictures", arguments->pictures, "Folder for a picture of each of the first 20 moments")
        ->type_name("DIR");
    command->add_option("--json", arguments->json, "The moments as JSON")->type_name("FILE");
    command->add_option("--junit", arguments->junit, "A test case a condition, for CI")->type_name("FILE");
    command->callback(
        [&request, arguments] { request.action = [&request, arguments] { return RunFind(*arguments, request); }; });
}

}  // namespace testbed
