// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree timeline`: a whole session in one page that plays in any browser, offline.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "testbed/base/errors.h"
#include "testbed/jobs/timeline/commands.h"
#include "testbed/jobs/timeline/motion_data.h"
#include "testbed/moments/conditions.h"
#include "testbed/options/options.h"
#include "testbed/options/session.h"
#include "testbed/page/page.h"
#include "testbed/page/page_markup.h"
#include "testbed_generated/timeline_sources.h"

namespace testbed {

namespace {

using Json = nlohmann::ordered_json;

struct TimelineArguments {
    SessionArguments session;
    std::string output = "timeline.html";
};

Json Numbers(const std::vector<Vec2>& points) {
    Json numbers = Json::array();
    for (const Vec2 p : points) numbers.push_back(p.x), numbers.push_back(p.y);
    return numbers;
}

/// What timeline.js draws of a fixture, in its body's coordinates.
Json ShapeOf(const FixtureState& fixture) {
    const scenes::Shape& shape = fixture.shape;
    if (!fixture.outline.empty()) return {{"v", Numbers(fixture.outline)}};
    if (shape.type == scenes::ShapeType::circle) {
        return {{"x", shape.center.x}, {"y", shape.center.y}, {"r", shape.radius}};
    }
    if (shape.type == scenes::ShapeType::edge) return {{"v", Numbers({shape.vertices[0], shape.vertices[1]})}};
    if (shape.type == scenes::ShapeType::box) {
        const float c = std::cos(shape.angle), s = std::sin(shape.angle);
        std::vector<Vec2> corners;
        for (const Vec2 sign : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}}) {
            const float x = sign.x * shape.halfExtents.x, y = sign.y * shape.halfExtents.y;
            corners.push_back({c * x - s * y + shape.center.x, s * x + c * y + shape.center.y});
        }
        return {{"v", Numbers(corners)}};
    }
    return {{"v", Numbers({shape.Vertices().begin(), shape.Vertices().end()})}};
}

/// The bodies of a session as they come, with their shapes.
class Bodies {
public:
    explicit Bodies(const Session& session) : m_session(session) {
        const std::size_t count = session.GetScene().bodies.size();
        if (count > mostTimelineBodies) {
            throw UsageError(fmt::format("{} bodies: a page holds at most {}", count, mostTimelineBodies));
        }
        for (std::size_t i = 0; i < count; ++i) {
            constexpr const char* types[] = {"static", "kinematic", "dynamic"};
            const auto type = static_cast<std::size_t>(session.GetScene().bodies[i].type);
            m_rows.push_back({{"index", i},
                              {"name", session.GetName(static_cast<int>(i))},
                              {"type", types[type]},
                              {"reach", 0.0},
                              {"shapes", Json::array()}});
        }
        m_isKnown.resize(count);
    }
    void Note(const Snapshot& snapshot) {
        const auto indexOf = [&](const FixtureState& fixture) {
            return static_cast<std::size_t>(snapshot.bodies[static_cast<std::size_t>(fixture.body)].index);
        };
        for (const FixtureState& fixture : snapshot.fixtures) {
            const std::size_t index = indexOf(fixture);
            if (m_isKnown[index]) continue;
            Json& row = m_rows[index];
            row["shapes"].push_back(ShapeOf(fixture));
            const Vec2 p = snapshot.bodies[static_cast<std::size_t>(fixture.body)].position;
            const double reach = std::max(std::hypot(fixture.tight.upper.x - p.x, fixture.tight.upper.y - p.y),
                                          std::hypot(fixture.tight.lower.x - p.x, fixture.tight.lower.y - p.y));
            if (std::isfinite(reach)) row["reach"] = std::max(row["reach"].get<double>(), reach);
        }
        for (const BodyState& body : snapshot.bodies) m_isKnown[static_cast<std::size_t>(body.index)] = true;
    }
    [[nodiscard]] const Json& GetRows() const { return m_rows; }

private:
    const Session& m_session;
    Json m_rows = Json::array();
    std::vector<bool> m_isKnown;
};

/// Around everything at the start, and around it as much again on each side: what flies off is shown at the edge.
Box ViewOf(const Snapshot& start) {
    Box box{{-5.0f, -5.0f}, {5.0f, 5.0f}};
    bool isFirst = true;
    for (const FixtureState& fixture : start.fixtures) {
        const Box& b = fixture.tight;
        if (!std::isfinite(b.lower.x + b.lower.y + b.upper.x + b.upper.y)) continue;
        if (isFirst) box = b;
        isFirst = false;
        box.lower = {std::min(box.lower.x, b.lower.x), std::min(box.lower.y, b.lower.y)};
        box.upper = {std::max(box.upper.x, b.upper.x), std::max(box.upper.y, b.upper.y)};
    }
    return box;
}

Box Grow(const Box& box) {
    const float by = std::max(box.upper.x - box.lower.x, box.upper.y - box.lower.y);
    return {{box.lower.x - by, box.lower.y - by}, {box.upper.x + by, box.upper.y + by}};
}

Json MomentsOf(const std::vector<Moment>& found, const Session& session) {
    Json rows = Json::array();
    for (const Moment& moment : found) {
        std::string bodies;
        for (const int body : moment.bodies) bodies += (bodies.empty() ? "" : ", ") + session.NameOf(body);
        rows.push_back(
            {{"step", moment.step},
             {"bodies", moment.bodies},
             {"text", fmt::format("step {}: {}: {}: {}", moment.step, moment.condition, bodies, moment.what)}});
    }
    return rows;
}

int RunTimeline(const TimelineArguments& arguments, const Request& request) {
    const SceneInput input = ChooseSessionInput(arguments.session);
    Session session = OpenSession(arguments.session, input);
    Bodies bodies(session);
    Conditions conditions;
    conditions.push_back(MakeTunnelCondition());
    conditions.push_back(MakeNonFiniteCondition());
    Watch watch(session.GetScene(), std::move(conditions));
    Snapshot snapshot = session.Capture();
    const Box view = ViewOf(snapshot), range = Grow(view);
    MotionData motion(session.GetScene().bodies.size(), range);
    Json steps = Json::array(), times = Json::array();
    double time = 0.0, timeStep = 0.0;
    for (bool goesOn = true; goesOn;) {
        bodies.Note(snapshot);
        motion.Add(snapshot);
        steps.push_back(session.GetStep());
        times.push_back(std::round(time * 1e6) / 1e6);
        watch.Show(std::move(snapshot), timeStep);
        goesOn = session.Step();
        if (!goesOn) break;
        snapshot = session.Capture();
        timeStep = session.GetTimeStep();
        time += timeStep;
    }
    const Json data{{"steps", steps},
                    {"times", times},
                    {"bodies", bodies.GetRows()},
                    {"view", {view.lower.x, view.lower.y, view.upper.x, view.upper.y}},
                    {"left", range.lower.x},
                    {"bottom", range.lower.y},
                    {"width", range.upper.x - range.lower.x},
                    {"height", range.upper.y - range.lower.y},
                    {"moments", MomentsOf(watch.Finish(), session)},
                    {"motion", EncodeBase64(motion.GetBytes())}};
    Page page{.title = fmt::format("{}: timeline", input.name),
              .intro = fmt::format("`{}`", DescribeCommand(request.arguments))};
    page.style = timeline_sources::timelineCss;
    page.script = timeline_sources::timelineJs;
    page.sections.push_back(
        {.blocks = {PageHtml{std::string(timeline_sources::timelineHtml) +
                             "<script type=\"application/json\" id=\"timeline-data\">" +
                             ProtectJson(data.dump(-1, ' ', false, Json::error_handler_t::replace)) + "</script>"}}});
    page.facts.push_back({"precision",
                          "positions to 1/65534 of three times the level; what flies farther stays at the edge; "
                          "speeds are those of the shown positions"});
    page.facts.push_back(
        {"keys", "space plays · ← → one step, with shift ten · click a body · wheel zooms · drag pans"});
    WritePage(arguments.output, page);
    fmt::print("{}\n{} steps, {} bodies, {} changes of a body\n", arguments.output, steps.size() - 1,
               session.GetScene().bodies.size(), motion.GetChangeCount());
    return exitDone;
}

}  // namespace

void AddTimelineCommand(CLI::App& app, Request& request) {
    CLI::App* command =
        app.add_subcommand("timeline", "A whole session as one page that plays in any browser, offline");
    auto arguments = std::make_shared<TimelineArguments>();
    AddSessionOptions(*command, arguments->session);
    command->add_option("-o,--output", arguments->output, "The page")->capture_default_str()->type_name("FILE");
    command->callback(
        [&request, arguments] { request.action = [&request, arguments] { return RunTimeline(*arguments, request); }; });
}

}  // namespace testbed
