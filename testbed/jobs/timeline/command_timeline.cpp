// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree timeline`: a whole session in one page that plays in any browser, offline; several engines beside each other.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "testbed/base/errors.h"
#include "testbed/base/json_print.h"
#include "testbed/base/new_file.h"
#include "testbed/input/track_file.h"
#include "testbed/jobs/timeline/commands.h"
#include "testbed/jobs/timeline/lane.h"
#include "testbed/options/condition_options.h"
#include "testbed/options/options.h"
#include "testbed/options/session.h"
#include "testbed/page/page.h"
#include "testbed/page/page_markup.h"
#include "testbed/view/camera.h"
#include "testbed_generated/timeline_sources.h"

namespace testbed {

namespace {

using Json = nlohmann::ordered_json;

/// Lanes that fit beside each other and have a colour of their own.
constexpr std::size_t mostLanes = 4;

struct TimelineArguments {
    SessionArguments session;
    ConditionArguments conditions;
    std::string engines, nodes, contacts = "on", positions = "view";
    std::string output = "timeline.html";
};

/// Around what moves, now or when it enters, and what is static near it: a long ground makes nothing small.
Box ViewOf(const Snapshot& start, const scenes::Scene& scene) {
    FitArea area;
    const Snapshot* const snapshots[] = {&start};
    AddStep(area, snapshots);
    std::vector<bool> isThere(scene.bodies.size());
    for (const BodyState& body : start.bodies) {
        if (static_cast<std::size_t>(body.index) < isThere.size()) isThere[static_cast<std::size_t>(body.index)] = true;
    }
    for (std::size_t i = 0; i < isThere.size(); ++i) {
        const scenes::Body& body = scene.bodies[i];
        if (isThere[i] || body.type == scenes::BodyType::isStatic) continue;
        if (!std::isfinite(body.position.x + body.position.y)) continue;
        constexpr float reach = 0.5f;  // m: of a body of a usual size
        const Box around{{body.position.x - reach, body.position.y - reach},
                         {body.position.x + reach, body.position.y + reach}};
        area.moving = area.moving ? Join(*area.moving, around) : around;
    }
    std::optional<Box> view = area.moving;
    if (area.moving) {                     // most things fall: what they fall onto belongs to the view, too
        constexpr float leastWay = 10.0f;  // m
        const Box box = *area.moving;
        area.moving->lower.y -= std::max({leastWay, box.upper.x - box.lower.x, box.upper.y - box.lower.y});
    }
    const std::vector<Box> boxes = GetFitBoxes(area);
    for (const Box& box : std::span(boxes).subspan(view ? 1 : 0)) {  // the first one is around what moves
        view = view ? Join(*view, box) : box;
    }
    return view.value_or(Box{{-5.0f, -5.0f}, {5.0f, 5.0f}});
}

/// The moments of all lanes. One that several lanes have is told once: trees of several engines may follow one motion.
class MomentRows {
public:
    void Add(const std::vector<Moment>& found, const Session& session, std::size_t lane) {
        for (const Moment& moment : found) {
            std::string bodies;
            for (const int body : moment.bodies) bodies += (bodies.empty() ? "" : ", ") + session.NameOf(body);
            Json row = {{"step", moment.step},
                        {"bodies", moment.bodies},
                        {"text", fmt::format("step {}: {}: {}{}{}", moment.step, moment.condition, bodies,
                                             bodies.empty() ? "" : ": ", moment.what)}};
            const auto [known, isNew] = m_places.try_emplace(row.dump(), m_rows.size());
            if (isNew) {
                row["lanes"] = Json::array();
                m_rows.push_back(std::move(row));
            }
            Json& lanes = m_rows[known->second]["lanes"];
            if (lanes.empty() || lanes.back() != lane) lanes.push_back(lane);
        }
    }
    /// All rows by time.
    [[nodiscard]] std::vector<Json> Take() {
        std::ranges::stable_sort(m_rows, {}, [](const Json& moment) { return moment["step"].get<int>(); });
        return std::move(m_rows);
    }

private:
    std::vector<Json> m_rows;
    std::unordered_map<std::string, std::size_t> m_places;  ///< of the rows by all but their lanes
};

/// Whether an option of two values has the first.
bool IsFirst(std::string_view option, std::string_view given, std::string_view first, std::string_view second) {
    if (given == first || given == second) return given == first;
    throw UsageError(fmt::format("{} {}: give {} or {}", option, given, first, second));
}

/// The lanes, the bodies that they share, and the moments of all by time.
struct Recorded {
    Json data;
    std::string streams;  ///< markup
    std::size_t steps = 0, changes = 0;
};

Recorded Record(std::vector<NamedSession> sessions, const TimelineArguments& arguments, const SceneInput& input) {
    LaneOptions options{.contacts = IsFirst("--contacts", arguments.contacts, "on", "off"),
                        .exact = IsFirst("--positions", arguments.positions, "exact", "view"),
                        .trees = ParseKeptTrees(arguments.nodes)};
    Session& first = sessions.front().session;
    const Box view = ViewOf(first.Capture(), first.GetScene());
    const Grid grid(view);
    BodyRows bodies(first.GetScene(), first.GetNames());
    Recorded recorded;
    Json lanes = Json::array();
    MomentRows moments;
    for (NamedSession& one : sessions) {
        AskedConditions asked = MakeConditionsAndMarks(arguments.conditions, arguments.session, input, one.session);
        const LaneData lane = RecordLane(one.session, one.name, std::move(asked.conditions), grid, bodies, options);
        moments.Add(lane.moments, one.session, lanes.size());
        for (const auto& [name, packed] : lane.streams) {
            recorded.streams += fmt::format("<script type=\"text/plain\" id=\"timeline-{}-{}\">{}</script>\n", name,
                                            lanes.size(), packed);
        }
        recorded.steps = std::max(recorded.steps, lane.told["steps"].size() - 1);
        recorded.changes += lane.changes;
        // Trees of the same steps, to compare them.
        if (options.trees.worst > 0) options.trees = KeptTrees{.steps = lane.told["nodeSteps"].get<std::vector<int>>()};
        lanes.push_back(lane.told);
    }
    recorded.data = {{"view", {view.lower.x, view.lower.y, view.upper.x, view.upper.y}},
                     {"unit", grid.GetUnit()},
                     {"exact", options.exact},
                     {"bodies", bodies.GetRows()},
                     {"lanes", lanes},
                     {"moments", moments.Take()}};
    return recorded;
}

/// Of --poses: the recorded motion, or every engine's own.
bool WantsTrack(const std::string& poses) { return !poses.empty() && IsFirst("--poses", poses, "track", "own"); }

int RunTimeline(TimelineArguments arguments, const Request& request) {
    const bool wantsTrack = WantsTrack(arguments.session.reading.poses);
    const SceneInput input = ChooseSessionInput(arguments.session);
    if (wantsTrack && arguments.engines.empty()) arguments.engines = EnginesOf(*input.motion);
    std::vector<NamedSession> sessions = OpenSessions(arguments.session, input, arguments.engines);
    if (sessions.size() > mostLanes) {
        throw UsageError(fmt::format("--engines {}: a page shows at most {}", arguments.engines, mostLanes));
    }
    const bool isAsRecorded = input.motion != nullptr && arguments.engines.empty();
    if (!arguments.nodes.empty() && isAsRecorded && !input.motion->GetInfo().hasNodes) {
        throw UsageError(
            fmt::format("--nodes: {} has no tree; record it with scree_capture::Options::tree = true, or "
                        "let those of engines follow it: --poses track",
                        arguments.session.input));
    }
    CheckCanWrite(arguments.output);
    const std::size_t bodyCount = sessions.front().session.GetScene().bodies.size();
    const Recorded recorded = Record(std::move(sessions), arguments, input);
    Page page{.title = fmt::format("{}: timeline", input.name),
              .intro = fmt::format("`{}`", DescribeCommand(request.arguments))};
    page.style = timeline_sources::timelineCss;
    page.script = timeline_sources::timelineJs;
    page.sections.push_back(
        {.blocks = {PageHtml{std::string(timeline_sources::timelineHtml) +
                             "<script type=\"application/json\" id=\"timeline-data\">" +
                             ProtectJson(PrintJson(recorded.data)) + "</script>\n" + recorded.streams}}});
    page.facts.push_back(
        {"precision",
         fmt::format(
             "{} to 1/65536 of the longer side of the first view, spins to 1/4096 rad/s, impulses and depths to "
             "eight bits",
             arguments.positions == "exact" ? "positions and angles to the bit, speeds" : "positions and speeds")});
    page.facts.push_back({"keys",
                          "space plays · ← → one step, with shift ten · Home End · n p next and last moment · [ ] loop "
                          "· f fit · Escape chooses nothing · shift and click choose one more"});
    WritePage(arguments.output, page);
    fmt::print("{}\n{} steps, {} bodies, {} changes of a body\n", arguments.output, recorded.steps, bodyCount,
               recorded.changes);
    return exitDone;
}

}  // namespace

void AddTimelineCommand(CLI::App& app, Request& request) {
    CLI::App* command =
        app.add_subcommand("timeline", "A whole session as one page that plays in any browser, offline");
    auto arguments = std::make_shared<TimelineArguments>();
    AddSessionOptions(*command, arguments->session);
    command
        ->add_option(
            "--engines", arguments->engines,
            "Up to four engines on one clock: [NAME=]ENGINE[:KEY=VALUE],..; of a motion: whose trees follow it")
        ->type_name("LIST");
    command
        ->add_option(
            "--poses", arguments->session.reading.poses,
            "track: the trees of the engines follow the recorded motion; engines: scree,box2d if not given, or the "
            "recorded tree in place of its engine's, where a track has one. "
            "own: every engine simulates. track if not given for a motion with --engines, else own")
        ->type_name("own|track");
    command
        ->add_option("--nodes", arguments->nodes,
                     "Keep the trees of some steps: every:N, worst:K (slowest of the first engine) or at:STEP,STEP")
        ->type_name("WHICH");
    command->add_option("--contacts", arguments->contacts, "on or off: contacts make the larger part of a page")
        ->capture_default_str()
        ->type_name("on|off");
    command
        ->add_option("--positions", arguments->positions,
                     "view: to 1/65536 of the longer side of the first view; exact: all bits of positions and angles, "
                     "which makes a page larger")
        ->capture_default_str()
        ->type_name("view|exact");
    AddConditionOptions(*command, arguments->conditions);
    command->add_option("-o,--output", arguments->output, "The page")->capture_default_str()->type_name("FILE");
    command->callback(
        [&request, arguments] { request.action = [&request, arguments] { return RunTimeline(*arguments, request); }; });
}

}  // namespace testbed
