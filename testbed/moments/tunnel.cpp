// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Bodies that go through static shapes. A body is its middle, a point fixed in it. A static shape is the segments of
// its outline. A body is watched from the step in which the way of its middle crosses such a segment. Either it comes
// back, since it is pushed out, or it has tunnelled. A body that is pushed out of a solid shape leaves it where it
// entered; one that tunnels leaves it elsewhere.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "testbed/moments/conditions.h"

namespace testbed {
namespace {

/// Time that a body has for coming back, s.
constexpr double patience = 0.5;
constexpr int circleSides = 16;

struct Segment {
    Vec2 from, to;
    Box box;
    int body, fixture;  ///< of the scene
    bool isOneSided;    ///< only what comes from its right collides
    bool isOfSolid;     ///< of an outline that goes around counter-clockwise
};

Vec2 Turn(const BodyState& body, Vec2 local) {
    return {body.cos * local.x - body.sin * local.y + body.position.x,
            body.sin * local.x + body.cos * local.y + body.position.y};
}

/// The outline of a shape in its body's coordinates: two points of an edge, else all corners.
std::vector<Vec2> OutlineOf(const FixtureState& fixture) {
    const scenes::Shape& shape = fixture.shape;
    if (!fixture.outline.empty()) return fixture.outline;
    switch (shape.type) {
        case scenes::ShapeType::edge:
            return {shape.vertices[0], shape.vertices[1]};
        case scenes::ShapeType::polygon:
        case scenes::ShapeType::capsule:
        case scenes::ShapeType::roundedPolygon:
            return {shape.Vertices().begin(), shape.Vertices().end()};
        case scenes::ShapeType::box: {
            const float c = std::cos(shape.angle), s = std::sin(shape.angle);
            std::vector<Vec2> corners;
            for (const auto& [x, y] : {std::pair{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
                const float dx = x * shape.halfExtents.x, dy = y * shape.halfExtents.y;
                corners.push_back({c * dx - s * dy + shape.center.x, s * dx + c * dy + shape.center.y});
            }
            return corners;
        }
        case scenes::ShapeType::circle: {
            std::vector<Vec2> corners;
            for (int i = 0; i < circleSides; ++i) {
                const float angle = 6.2831853f * static_cast<float>(i) / circleSides;
                corners.push_back(
                    {shape.center.x + shape.radius * std::cos(angle), shape.center.y + shape.radius * std::sin(angle)});
            }
            return corners;
        }
        default:
            return {};
    }
}

double Cross(Vec2 a, Vec2 b, Vec2 c) {
    return (double{b.x} - a.x) * (double{c.y} - a.y) - (double{b.y} - a.y) * (double{c.x} - a.x);
}

/// A segment on the way of a middle.
struct Hit {
    double at = 0;  ///< share of the way
    const Segment* segment = nullptr;
    int side = 0;
    Vec2 point{};
};

/// +1: from the segment's right to its left, −1: the other way, 0: it is not crossed.
int Crossing(const Segment& segment, Vec2 from, Vec2 to) {
    const double before = Cross(segment.from, segment.to, from), after = Cross(segment.from, segment.to, to);
    if ((before < 0.0) == (after < 0.0)) return 0;
    if ((Cross(from, to, segment.from) < 0.0) == (Cross(from, to, segment.to) < 0.0)) return 0;
    return before < 0.0 ? 1 : -1;
}

bool Collides(const scenes::Scene& scene, int bodyA, int bodyB, const scenes::Fixture& other) {
    for (const scenes::Joint& joint : scene.joints) {
        const bool isBetween =
            (joint.bodyA == bodyA && joint.bodyB == bodyB) || (joint.bodyA == bodyB && joint.bodyB == bodyA);
        if (isBetween && !joint.collideConnected) return false;
    }
    for (const scenes::Fixture& own : scene.FixturesOf(bodyA)) {
        if (own.isSensor || other.isSensor) continue;
        const bool isOfGroup = own.groupIndex != 0 && own.groupIndex == other.groupIndex;
        if (isOfGroup ? own.groupIndex > 0
                      : (own.maskBits & other.categoryBits) != 0 && (own.categoryBits & other.maskBits) != 0) {
            return true;
        }
    }
    return false;
}

class Tunnel final : public Condition {
public:
    void Look(const Frame& frame, std::vector<Moment>& found) override {
        if (frame.before != nullptr) {
            UpdateSegments(*frame.before);
            FindMiddles(frame);
            for (const BodyState& body : frame.now.bodies) LookAt(frame, body);
        }
        std::erase_if(m_watched, [&](const auto& one) {
            const bool isGone = frame.placeNow[static_cast<std::size_t>(one.first.first)] < 0;
            if (!isGone && frame.time - one.second.time <= patience) return false;
            Add(one.first, one.second, found);
            return true;
        });
    }
    void Finish(std::vector<Moment>& found) override {
        for (const auto& [key, watched] : m_watched) Add(key, watched, found);
        m_watched.clear();
    }

private:
    using Key = std::pair<int, int>;  ///< indices of a body and of a static fixture in the scene
    struct Watched {
        int step = 0, staticBody = 0;
        double time = 0, speed = 0;
        int side = 0;           ///< sum of crossings
        Vec2 entry{};           ///< where the segment begins through which it went,
        Vec2 inward{};          ///< and its normal to the left, of length 1
        bool isInside = false;  ///< of what is solid
    };

    /// Anew if static shapes are not what they were.
    void UpdateSegments(const Snapshot& now) {
        std::vector<float> poses;
        for (const BodyState& body : now.bodies) {
            if (body.type != scenes::BodyType::isStatic) continue;
            poses.insert(poses.end(),
                         {static_cast<float>(body.index), body.position.x, body.position.y, body.sin, body.cos});
        }
        poses.push_back(static_cast<float>(now.fixtures.size()));
        if (poses == m_poses) return;
        m_poses = std::move(poses);
        m_segments.clear();
        for (const FixtureState& fixture : now.fixtures) {
            const BodyState& body = now.bodies[static_cast<std::size_t>(fixture.body)];
            if (body.type != scenes::BodyType::isStatic || fixture.sensor) continue;
            std::vector<Vec2> outline = OutlineOf(fixture);
            for (Vec2& corner : outline) corner = Turn(body, corner);
            const std::size_t sides = outline.size() == 2 ? 1 : outline.size();
            for (std::size_t i = 0; i < sides; ++i) {
                const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
                m_segments.push_back(
                    {a,
                     b,
                     {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}},
                     body.index,
                     fixture.fixture,
                     fixture.shape.IsOneSidedEdge(),
                     sides > 1});
            }
        }
        m_collides.clear();
        SortSegments();
    }

    /// By their left ends, the narrow ones first: of those only few can be at one place.
    void SortSegments() {
        std::vector<float> widths;
        for (const Segment& segment : m_segments) widths.push_back(segment.box.upper.x - segment.box.lower.x);
        std::ranges::sort(widths);
        m_narrowWidth = widths.empty() ? 0.0f : 4.0f * widths[widths.size() / 2];
        const auto isWide = [&](const Segment& s) { return s.box.upper.x - s.box.lower.x > m_narrowWidth; };
        std::ranges::sort(m_segments, [&](const Segment& a, const Segment& b) {
            return std::pair(isWide(a), a.box.lower.x) < std::pair(isWide(b), b.box.lower.x);
        });
        m_narrowCount = static_cast<std::size_t>(std::ranges::count_if(m_segments, std::not_fn(isWide)));
    }

    /// Calls `action` with every segment that may be at a place between two x.
    template <typename Action>
    void ForSegments(float left, float right, Action&& action) const {
        const auto end = m_segments.begin() + static_cast<std::ptrdiff_t>(m_narrowCount);
        auto at = std::lower_bound(m_segments.begin(), end, left - m_narrowWidth,
                                   [](const Segment& segment, float x) { return segment.box.lower.x < x; });
        for (; at != end && at->box.lower.x <= right; ++at) action(*at);
        for (at = end; at != m_segments.end() && at->box.lower.x <= right; ++at) action(*at);
    }

    /// The mean of all corners of each body that is new: a point inside what is convex.
    void FindMiddles(const Frame& frame) {
        m_middles.resize(frame.scene.bodies.size());
        if (std::ranges::none_of(frame.now.bodies, [&](const BodyState& body) {
                return body.type == scenes::BodyType::dynamic &&
                       !m_middles[static_cast<std::size_t>(body.index)].isKnown;
            })) {
            return;
        }
        std::vector<Middle> sums(frame.scene.bodies.size());
        const auto indexOf = [&](const FixtureState& fixture) {
            return static_cast<std::size_t>(frame.now.bodies[static_cast<std::size_t>(fixture.body)].index);
        };
        for (const FixtureState& fixture : frame.now.fixtures) {
            const std::size_t index = indexOf(fixture);
            if (m_middles[index].isKnown || fixture.sensor) continue;
            for (const Vec2 corner : OutlineOf(fixture)) {
                sums[index].point = {sums[index].point.x + corner.x, sums[index].point.y + corner.y};
                ++sums[index].count;
            }
        }
        for (std::size_t i = 0; i < sums.size(); ++i) {
            if (sums[i].count == 0) continue;
            const auto count = static_cast<float>(sums[i].count);
            m_middles[i] = {{sums[i].point.x / count, sums[i].point.y / count}, sums[i].count};
        }
        for (const BodyState& body : frame.now.bodies) m_middles[static_cast<std::size_t>(body.index)].isKnown = true;
        for (const FixtureState& fixture : frame.now.fixtures) {
            const std::size_t index = indexOf(fixture);
            if (sums[index].count == 0 || fixture.sensor) continue;
            Middle& middle = m_middles[index];
            for (const Vec2 corner : OutlineOf(fixture)) {
                middle.reach = std::max(middle.reach, std::hypot(corner.x - middle.point.x, corner.y - middle.point.y));
            }
        }
    }

    void LookAt(const Frame& frame, const BodyState& body) {
        const int place = frame.placeBefore[static_cast<std::size_t>(body.index)];
        if (body.type != scenes::BodyType::dynamic || place < 0) return;
        const BodyState& before = frame.before->bodies[static_cast<std::size_t>(place)];
        if (before.position == body.position && before.sin == body.sin) return;
        const Vec2 middle = m_middles[static_cast<std::size_t>(body.index)].point;
        const Vec2 from = Turn(before, middle), to = Turn(body, middle);
        if (IsCarried(frame, before, body, std::hypot(to.x - from.x, to.y - from.y))) return;
        const Box way{{std::min(from.x, to.x), std::min(from.y, to.y)},
                      {std::max(from.x, to.x), std::max(from.y, to.y)}};
        m_hits.clear();
        ForSegments(way.lower.x, way.upper.x, [&](const Segment& segment) {
            if (segment.box.lower.x > way.upper.x || segment.box.upper.x < way.lower.x ||
                segment.box.lower.y > way.upper.y || segment.box.upper.y < way.lower.y) {
                return;
            }
            const int side = Crossing(segment, from, to);
            if (side == 0 || !CanCollide(frame.scene, body.index, segment)) return;
            const double near = Cross(segment.from, segment.to, from), far = Cross(segment.from, segment.to, to);
            const double share = near / (near - far);
            const auto along = static_cast<float>(share);
            m_hits.push_back(
                {share, &segment, side, {from.x + along * (to.x - from.x), from.y + along * (to.y - from.y)}});
        });
        std::ranges::sort(m_hits, {}, &Hit::at);
        for (const Hit& hit : m_hits) Pass(frame, body, hit, std::hypot(to.x - from.x, to.y - from.y));
    }

    /// Whether a body was put elsewhere by the program: it is farther from where it was than its speed explains. What
    /// was watched of it is forgotten.
    bool IsCarried(const Frame& frame, const BodyState& before, const BodyState& body, float way) {
        const float speed = std::max(std::hypot(before.linearVelocity.x, before.linearVelocity.y),
                                     std::hypot(body.linearVelocity.x, body.linearVelocity.y));
        const float reach = m_middles[static_cast<std::size_t>(body.index)].reach;
        if (way <= 2.0f * (speed * static_cast<float>(frame.timeStep) + reach)) return false;
        std::erase_if(m_watched, [&](const auto& one) { return one.first.first == body.index; });
        return true;
    }

    bool CanCollide(const scenes::Scene& scene, int body, const Segment& segment) {
        const auto [at, isNew] = m_collides.try_emplace({body, segment.fixture});
        if (isNew) {
            at->second = Collides(scene, body, segment.body, scene.fixtures[static_cast<std::size_t>(segment.fixture)]);
        }
        return at->second;
    }

    void Pass(const Frame& frame, const BodyState& body, const Hit& hit, double length) {
        const Segment& segment = *hit.segment;
        const Key key{body.index, segment.fixture};
        const auto known = m_watched.find(key);
        if (known == m_watched.end()) {
            // Outlines go around counter-clockwise: their inside is on the left.
            if ((segment.isOneSided || segment.isOfSolid) && hit.side < 0) return;
            const double speed = frame.timeStep > 0.0 ? length / frame.timeStep : 0.0;
            const Vec2 along{segment.to.x - segment.from.x, segment.to.y - segment.from.y};
            const float size = std::hypot(along.x, along.y);
            m_watched[key] = {.step = frame.now.step,
                              .staticBody = segment.body,
                              .time = frame.time,
                              .speed = speed,
                              .side = hit.side,
                              .entry = segment.from,
                              .inward = {-along.y / size, along.x / size},
                              .isInside = segment.isOfSolid};
            return;
        }
        Watched& watched = known->second;
        watched.side += hit.side;
        watched.isInside = segment.isOfSolid && hit.side > 0;
        if (segment.isOfSolid ? hit.side < 0 && !IsFar(watched, segment, hit.point) : watched.side == 0) {
            m_watched.erase(known);
        }
    }

    /// Whether a point of an outline lies in the far half of it.
    bool IsFar(const Watched& watched, const Segment& left, Vec2 point) const {
        const auto depthOf = [&](Vec2 p) {
            return (p.x - watched.entry.x) * watched.inward.x + (p.y - watched.entry.y) * watched.inward.y;
        };
        float deepest = 0.0f;
        for (const Segment& segment : m_segments) {
            if (segment.fixture == left.fixture) deepest = std::max(deepest, depthOf(segment.from));
        }
        return depthOf(point) > 0.5f * deepest;
    }

    static void Add(const Key& key, const Watched& watched, std::vector<Moment>& found) {
        if (watched.isInside) return;  // it is stuck: that is overlap
        found.push_back({"tunnel",
                         watched.step,
                         watched.time,
                         watched.step,
                         {key.first, watched.staticBody},
                         watched.speed,
                         "m/s",
                         fmt::format("went through, at {:.4g} m/s", watched.speed)});
    }

    struct Middle {
        Vec2 point{};
        int count = 0;  ///< corners
        bool isKnown = false;
        float reach = 0.0f;  ///< from it to the farthest corner
    };

    std::vector<float> m_poses;  ///< of static bodies, for which the segments are
    std::vector<Segment> m_segments;
    std::size_t m_narrowCount = 0;  ///< segments that are no wider than
    float m_narrowWidth = 0.0f;
    std::vector<Middle> m_middles;  ///< by index of a body
    std::vector<Hit> m_hits;        ///< of one body in a step
    std::map<Key, bool> m_collides;
    std::map<Key, Watched> m_watched;
};

}  // namespace

std::unique_ptr<Condition> MakeTunnelCondition() { return std::make_unique<Tunnel>(); }

}  // namespace testbed
