// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of track_run.h. A track has angles. Rotations and boxes are made of them as the recorded engine makes
// them, so that trees that follow get the same bits as its own tree.

#include "testbed/engines/track_run.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "scenes/outline.h"
#include "scree/math.h"
#include "testbed/engines/box2d_shape.h"
#include "testbed/engines/pair_count.h"
#include "testbed/engines/scree_shape.h"
#include "testbed/engines/state_hash.h"

namespace testbed {
namespace {

/// A child of a fixture as the engine that was recorded had it.
using RecordedShape = std::variant<ScreeShape, Box2dShape>;

struct Place {
    Vec2 position;
    float sin, cos;

    [[nodiscard]] Vec2 Of(Vec2 local) const {
        return {cos * local.x - sin * local.y + position.x, sin * local.x + cos * local.y + position.y};
    }
};

struct BoxOf {
    const Place& at;

    Box operator()(const ScreeShape& shape) const {
        scree::Transform pose;
        pose.p = ToScree(at.position);
        pose.q.s = at.sin;
        pose.q.c = at.cos;
        scree::AABB box;
        AsShape(shape).ComputeAABB(&box, pose);
        return FromScree(box);
    }
    Box operator()(const Box2dShape& shape) const {
        b2Transform pose;
        pose.p = ToB2(at.position);
        pose.q.s = at.sin;
        pose.q.c = at.cos;
        b2AABB box;
        AsB2Shape(shape).ComputeAABB(&box, pose, 0);
        return FromB2(box);
    }
};

/// The stages of either engine by the testbed's names.
StepTimes TimesOf(const TrackStep& step) {
    constexpr std::pair<std::string_view, double StepTimes::*> names[] = {{"step", &StepTimes::step},
                                                                          {"broadPhase", &StepTimes::broadPhase},
                                                                          {"broadphase", &StepTimes::broadPhase},
                                                                          {"narrowPhase", &StepTimes::narrowPhase},
                                                                          {"collide", &StepTimes::narrowPhase},
                                                                          {"solver", &StepTimes::solver},
                                                                          {"solve", &StepTimes::solver},
                                                                          {"islands", &StepTimes::islands},
                                                                          {"continuous", &StepTimes::continuous},
                                                                          {"solveTOI", &StepTimes::continuous}};
    StepTimes times;
    for (const auto& [stage, milliseconds] : step.stages) {
        for (const auto& [name, member] : names) {
            if (stage == name) times.*member = double{milliseconds};
        }
    }
    return times;
}

Place PlaceOf(const BodyState& body) { return {body.position, body.sin, body.cos}; }

class TrackRun final : public EngineRun {
public:
    TrackRun(std::shared_ptr<TrackFile> track, int from)
        : m_track(std::move(track)), m_isScree(m_track->GetInfo().engine == "scree"), m_step(from) {
        const std::vector<int>& steps = m_track->GetSteps();
        m_next = static_cast<size_t>(std::upper_bound(steps.begin(), steps.end(), from) - steps.begin());
        (void)m_track->Read(from);  // or it throws
        const scenes::Scene& parts = m_track->GetParts();
        for (const scenes::Fixture& fixture : parts.fixtures) {
            m_firstShape.push_back(m_shapes.size());
            for (int child = 0; child < fixture.shape.ChildCount(); ++child) AddShape(fixture.shape, child);
        }
    }

    void Step() override {
        const std::vector<int>& steps = m_track->GetSteps();
        if (m_next >= steps.size()) throw std::out_of_range("the recording ends here");
        m_step = steps[m_next++];
    }
    [[nodiscard]] int GetStep() const override { return m_step; }
    [[nodiscard]] StepTimes GetTimes() const override { return TimesOf(m_track->Read(m_step)); }
    [[nodiscard]] int GetContactCount() const override { return CountContacts(m_track->Read(m_step)); }
    [[nodiscard]] StepCounts CountStep() override {
        const TrackStep& step = m_track->Read(m_step);
        const auto awake = std::ranges::count_if(step.bodies, [](const TrackState& b) { return b.isThere && b.awake; });
        return {static_cast<int>(awake), static_cast<int>(step.contacts.size()), CountContacts(step)};
    }
    [[nodiscard]] double GetCreateMilliseconds() const override { return 0; }
    [[nodiscard]] int64_t GetPeakBytes() const override { return 0; }
    void Capture(Snapshot& snapshot, const CaptureParts& parts) override;

private:
    static int CountContacts(const TrackStep& step) {
        return std::max(step.contactCount, static_cast<int>(step.contacts.size()));
    }
    void AddShape(const scenes::Shape& shape, int child) {
        const scenes::Scene& parts = m_track->GetParts();
        const scenes::Shape one = scenes::ChildOf(parts, shape, child);
        std::vector<Vec2>& outline = m_outlines.emplace_back();
        if (m_isScree) {
            m_shapes.emplace_back(MakeScreeShape(parts, one));
            if (scenes::IsFurtherConvex(one.type)) outline = scenes::SampleOutline(parts, one, outlineDirections);
        } else {
            m_shapes.emplace_back(MakeBox2dShape(Box2dShapeOf(parts, one)));
        }
    }
    [[nodiscard]] BodyState StateOf(int index, const TrackState& state) const;
    void CaptureFixtures(Snapshot& snapshot, std::vector<int>& firstFixtureOf) const;
    void CaptureContacts(const TrackStep& step, const std::vector<int>& firstFixtureOf, Snapshot& snapshot) const;
    void CaptureJoints(const std::vector<int>& placeOf, Snapshot& snapshot) const;
    void CaptureNodes(const TrackStep& step, const std::vector<int>& firstFixtureOf, Snapshot& snapshot) const;
    /// Index into Snapshot::fixtures.
    [[nodiscard]] int FixtureAt(const TrackPlace& place, const std::vector<int>& firstFixtureOf) const {
        const int first = m_track->GetParts().bodies[static_cast<size_t>(place.body)].firstFixture;
        return firstFixtureOf[static_cast<size_t>(first + place.fixture)] + place.child;
    }

    std::shared_ptr<TrackFile> m_track;
    bool m_isScree;
    int m_step;
    size_t m_next;  ///< index of the step after this one
    std::vector<RecordedShape> m_shapes;
    std::vector<std::vector<Vec2>> m_outlines;  ///< of `m_shapes`, where FixtureState has one
    std::vector<size_t> m_firstShape;           ///< by fixture of the parts
};

BodyState TrackRun::StateOf(int index, const TrackState& state) const {
    const scenes::Body& body = m_track->GetParts().bodies[static_cast<size_t>(index)];
    BodyState made{.index = index,
                   .type = body.type,
                   .position = state.position,
                   .sin = std::sin(state.angle),
                   .cos = std::cos(state.angle),
                   .angle = state.angle,
                   .linearVelocity = state.linearVelocity,
                   .angularVelocity = state.angularVelocity,
                   .awake = state.awake,
                   .bullet = body.bullet};
    if (m_isScree) {
        const scree::Rot rotation(state.angle);
        made.sin = rotation.s;
        made.cos = rotation.c;
    }
    return made;
}

void TrackRun::CaptureFixtures(Snapshot& snapshot, std::vector<int>& firstFixtureOf) const {
    const scenes::Scene& parts = m_track->GetParts();
    for (size_t i = 0; i < snapshot.bodies.size(); ++i) {
        const BodyState& body = snapshot.bodies[i];
        const Place at = PlaceOf(body);
        const scenes::Body& part = parts.bodies[static_cast<size_t>(body.index)];
        for (int f = part.firstFixture; f < part.firstFixture + part.fixtureCount; ++f) {
            const scenes::Fixture& fixture = parts.fixtures[static_cast<size_t>(f)];
            firstFixtureOf[static_cast<size_t>(f)] = static_cast<int>(snapshot.fixtures.size());
            for (int child = 0; child < fixture.shape.ChildCount(); ++child) {
                const size_t shape = m_firstShape[static_cast<size_t>(f)] + static_cast<size_t>(child);
                FixtureState state{.body = static_cast<int>(i),
                                   .fixture = f,
                                   .child = child,
                                   .shape = scenes::ChildOf(parts, fixture.shape, child),
                                   .sensor = fixture.isSensor,
                                   .tight = std::visit(BoxOf{at}, m_shapes[shape])};
                if (!m_isScree) state.shape = Box2dShapeOf(parts, state.shape);
                state.outline = m_outlines[shape];
                state.swept = state.tight;
                snapshot.fixtures.push_back(std::move(state));
            }
        }
    }
}

void TrackRun::CaptureContacts(const TrackStep& step, const std::vector<int>& firstFixtureOf,
                               Snapshot& snapshot) const {
    for (const TrackContact& contact : step.contacts) {
        ContactState state{};
        state.fixtureA = FixtureAt(contact.a, firstFixtureOf);
        state.fixtureB = FixtureAt(contact.b, firstFixtureOf);
        state.touching = true;
        state.pointCount = contact.pointCount;
        state.normal = contact.normal;
        for (size_t k = 0; k < static_cast<size_t>(contact.pointCount); ++k) {
            state.points[k] = contact.points[k];
            state.separations[k] = contact.separations[k];
            state.normalImpulses[k] = contact.normalImpulses[k];
            state.tangentImpulses[k] = contact.tangentImpulses[k];
        }
        snapshot.contacts.push_back(state);
    }
}

void TrackRun::CaptureJoints(const std::vector<int>& placeOf, Snapshot& snapshot) const {
    const std::vector<scenes::Joint>& joints = m_track->GetParts().joints;
    for (size_t i = 0; i < joints.size(); ++i) {
        const scenes::Joint& joint = joints[i];
        const int a = placeOf[static_cast<size_t>(joint.bodyA)], b = placeOf[static_cast<size_t>(joint.bodyB)];
        if (!m_track->GetJoints()[i].IsThere(m_step) || a < 0 || b < 0) continue;
        JointState state{.bodyA = a,
                         .bodyB = b,
                         .anchorA = PlaceOf(snapshot.bodies[static_cast<size_t>(a)]).Of(joint.localAnchorA),
                         .anchorB = PlaceOf(snapshot.bodies[static_cast<size_t>(b)]).Of(joint.localAnchorB),
                         .type = joint.type};
        if (joint.type == scenes::JointType::mouse) state.anchorA = joint.target;
        if (joint.type == scenes::JointType::pulley) {
            state.groundAnchorA = joint.groundAnchorA;
            state.groundAnchorB = joint.groundAnchorB;
        }
        snapshot.joints.push_back(state);
    }
}

void TrackRun::CaptureNodes(const TrackStep& step, const std::vector<int>& firstFixtureOf, Snapshot& snapshot) const {
    snapshot.leafSize = step.nodes.empty() ? 0 : 1;
    snapshot.nodes.reserve(step.nodes.size());
    for (const TrackNode& node : step.nodes) {
        const bool isLeaf = node.child1 < 0;
        const int level = node.parent < 0 ? 0 : snapshot.nodes[static_cast<size_t>(node.parent)].level + 1;
        snapshot.nodes.push_back({{node.lower, node.upper},
                                  node.parent,
                                  node.child1,
                                  node.child2,
                                  isLeaf ? FixtureAt(node.leaf, firstFixtureOf) : -1,
                                  level});
        snapshot.treeHeight = std::max(snapshot.treeHeight, level);
    }
}

void TrackRun::Capture(Snapshot& snapshot, const CaptureParts& parts) {
    const TrackStep& step = m_track->Read(m_step);
    const scenes::Scene& scene = m_track->GetParts();
    ClearWorld(snapshot);
    snapshot.engine = m_isScree ? "scree" : "box2d";
    snapshot.broadPhase = m_track->GetInfo().hasNodes ? m_track->GetInfo().engine : "recorded";
    snapshot.scene = scene.name;
    snapshot.size = scene.size;
    snapshot.step = m_step;
    snapshot.times = TimesOf(step);
    snapshot.contactCount = CountContacts(step);
    snapshot.touchingCount = static_cast<int>(step.contacts.size());
    std::vector<int> placeOf(step.bodies.size(), -1), firstFixtureOf(scene.fixtures.size(), -1);
    for (size_t i = 0; i < step.bodies.size(); ++i) {
        if (!step.bodies[i].isThere) continue;
        placeOf[i] = static_cast<int>(snapshot.bodies.size());
        snapshot.bodies.push_back(StateOf(static_cast<int>(i), step.bodies[i]));
    }
    snapshot.stateHash = HashState(snapshot.bodies);
    if (parts.fixtures || parts.contacts || parts.nodes) CaptureFixtures(snapshot, firstFixtureOf);
    if (parts.contacts) CaptureContacts(step, firstFixtureOf, snapshot);
    if (parts.joints) CaptureJoints(placeOf, snapshot);
    if (parts.nodes) CaptureNodes(step, firstFixtureOf, snapshot);
    if (parts.nodes && parts.pairs) snapshot.pairsReported = CountPairs(LeafBoxes(snapshot));
    if (!parts.fixtures) snapshot.fixtures.clear();
}

}  // namespace

int FirstStepOf(const TrackFile& track) {
    const std::vector<int>& steps = track.GetSteps();
    return steps.empty() || steps.front() == 1 ? 0 : steps.front();
}

std::unique_ptr<EngineRun> MakeTrackRun(std::shared_ptr<TrackFile> track, int from) {
    return std::make_unique<TrackRun>(std::move(track), from);
}

}  // namespace testbed
