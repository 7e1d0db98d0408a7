// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What holds of every world after a step, whatever was done to it. A fault here would be the same in every replay.

#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "scree/scree.h"
#include "tests/fuzz/input.h"

namespace fuzz {

/// No state becomes NaN or infinite, nor does what a joint does to a dynamic body.
inline void CheckFinite(const scree::World& world) {
    for (const scree::Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
        const bool isFinite = body->GetPosition().IsValid() && std::isfinite(body->GetAngle()) &&
                              body->GetWorldCenter().IsValid() && body->GetLinearVelocity().IsValid() &&
                              std::isfinite(body->GetAngularVelocity());
        Demand(isFinite, "states stay finite");
    }
    for (const scree::Joint* joint = world.GetJointList(); joint != nullptr; joint = joint->GetNext()) {
        const auto isDynamic = [](const scree::Body* body) { return body->GetType() == scree::dynamicBody; };
        if (!isDynamic(joint->GetBodyA()) && !isDynamic(joint->GetBodyB())) continue;
        const bool isFinite = joint->GetReactionForce(1.0f).IsValid() && std::isfinite(joint->GetReactionTorque(1.0f));
        Demand(isFinite, "reactions stay finite");
    }
}

/// Where rounding does not decide.
inline bool IsNear(scree::Vec2 a) {
    constexpr float near = 1e4f;
    return std::abs(a.x) < near && std::abs(a.y) < near;
}
inline bool IsNear(const scree::AABB& box) { return IsNear(box.lowerBound) && IsNear(box.upperBound); }

/// Of each fixture: it holds the shape, and in all but the fat tree no more. Not where some body, or its centre of
/// mass, is or was far out.
inline void CheckBoxes(const scree::World& world, bool areTight) {
    constexpr float tolerance = 0.01f;
    for (const scree::Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
        if (!body->IsEnabled() || !IsNear(body->GetWorldCenter())) continue;
        for (const scree::Fixture* f = body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
            const scree::AABB box = f->GetAABB();
            scree::AABB shape;
            f->GetShape()->ComputeAABB(&shape, body->GetTransform());
            if (!IsNear(shape)) continue;
            const scree::Vec2 below = shape.lowerBound - box.lowerBound, above = box.upperBound - shape.upperBound;
            const float least = std::min({below.x, below.y, above.x, above.y});
            const float most = std::max({below.x, below.y, above.x, above.y});
            Demand(least >= -tolerance, "the box of a fixture holds its shape");
            Demand(!areTight || most <= tolerance, "the box of a fixture is tight");
        }
    }
}

/// Calls visit(fixture) for all of enabled bodies.
template <typename Visit>
void ForEachFixture(const scree::World& world, Visit&& visit) {
    for (const scree::Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
        if (!body->IsEnabled()) continue;
        for (const scree::Fixture* f = body->GetFixtureList(); f != nullptr; f = f->GetNext()) visit(*f);
    }
}

/// Queries find what a look at all fixtures finds, whatever was edited since the last step. Points are looked for in
/// what is near.
inline void CheckQueries(const scree::World& world, const scree::AABB& box, scree::Vec2 point) {
    std::set<const scree::Fixture*> boxes, points, foundBoxes, foundPoints;
    ForEachFixture(world, [&](const scree::Fixture& fixture) {
        if (TestOverlap(fixture.GetAABB(), box)) boxes.insert(&fixture);
        if (IsNear(fixture.GetAABB()) && fixture.TestPoint(point)) points.insert(&fixture);
    });
    const auto addTo = [](std::set<const scree::Fixture*>& found) {
        return [&found](scree::Fixture* fixture) { return found.insert(fixture).second; };
    };
    if (world.QueryAABB(box, addTo(foundBoxes)) == scree::ErrorCode::ok)
        Demand(foundBoxes == boxes, "a box finds the boxes that overlap it");
    if (world.QueryPoint(point, addTo(foundPoints)) == scree::ErrorCode::ok) {
        std::erase_if(foundPoints, [](const scree::Fixture* fixture) { return !IsNear(fixture->GetAABB()); });
        Demand(foundPoints == points, "a point finds the fixtures that contain it");
    }
}

/// So do rays and shapes on their way, and where they hit is what one fixture says of it alone. Asked of what is near.
inline void CheckRays(const scree::World& world, scree::Vec2 p1, scree::Vec2 p2,
                      const std::vector<scree::RayHit>& hits) {
    if (!IsNear(p1) || !IsNear(p2)) return;
    std::map<const scree::Fixture*, float> expected, found;
    ForEachFixture(world, [&](const scree::Fixture& fixture) {
        scree::RayCastOutput hit;
        if (IsNear(fixture.GetAABB()) && fixture.RayCast(&hit, {p1, p2, 1.0f}))
            expected.emplace(&fixture, hit.fraction);
    });
    for (const scree::RayHit& hit : hits) {
        if (IsNear(hit.fixture->GetAABB()))
            Demand(found.emplace(hit.fixture, hit.fraction).second, "a ray hits a fixture once");
    }
    Demand(found == expected, "a ray hits the fixtures that are on it");
}

inline void CheckCasts(const scree::World& world, const scree::Shape& shape, const scree::Transform& xf,
                       scree::Vec2 way, const std::vector<scree::ShapeHit>& hits) {
    scree::AABB start;
    shape.ComputeAABB(&start, xf);
    if (!IsNear(start) || !IsNear(way)) return;
    std::map<const scree::Fixture*, float> expected, found;
    ForEachFixture(world, [&](const scree::Fixture& fixture) {
        if (!IsNear(fixture.GetAABB())) return;
        const scree::Shape& other = *fixture.GetShape();
        scree::ShapeCastInput input;
        input.proxyA.Set(&other, 0), input.proxyB.Set(&shape, 0);
        input.transformA = fixture.GetBody()->GetTransform(), input.transformB = xf;
        input.translationB = way;
        scree::ShapeCastOutput hit;
        if (TestOverlap(&other, 0, &shape, 0, input.transformA, xf)) {
            expected.emplace(&fixture, 0.0f);
        } else if (ShapeCast(&hit, &input)) {
            expected.emplace(&fixture, hit.lambda);
        }
    });
    for (const scree::ShapeHit& hit : hits) {
        if (IsNear(hit.fixture->GetAABB()))
            Demand(found.emplace(hit.fixture, hit.fraction).second, "a shape hits a fixture once");
    }
    Demand(found == expected, "a shape hits the fixtures that are in its way");
}

/// Lists have what counts say, and a body has the joints that have it.
inline void CheckLists(const scree::World& world) {
    int bodies = 0, joints = 0, ofBodies = 0, contacts = 0;
    for (const scree::Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
        ++bodies;
        for (const scree::Joint* joint = body->GetJointList(); joint != nullptr; joint = joint->GetNext(body)) {
            ++ofBodies;
            Demand(joint->GetBodyA() == body || joint->GetBodyB() == body, "a body has its own joints");
        }
    }
    for (const scree::Joint* joint = world.GetJointList(); joint != nullptr; joint = joint->GetNext()) {
        ++joints;
        ofBodies -= joint->GetBodyA() == joint->GetBodyB() ? 1 : 2;
    }
    for (const scree::Contact* contact = world.GetContactList(); contact != nullptr; contact = contact->GetNext())
        ++contacts;
    Demand(bodies == world.GetBodyCount(), "all bodies are listed");
    Demand(joints == world.GetJointCount(), "all joints are listed");
    Demand(contacts == world.GetContactCount(), "all contacts are listed");
    Demand(ofBodies == 0, "each joint is listed by its bodies");
}

/// After a step of some time: who touches somebody that is awake is awake. An impact at its end wakes whom it hits
/// alone.
inline void CheckSleep(const scree::World& world) {
    if (world.GetReport().continuousEventCount > 0) return;
    const auto isMovable = [](const scree::Body& body) {
        return body.GetType() == scree::dynamicBody && body.IsEnabled();
    };
    for (const scree::Contact* contact = world.GetContactList(); contact != nullptr; contact = contact->GetNext()) {
        const scree::Fixture &a = *contact->GetFixtureA(), &b = *contact->GetFixtureB();
        if (!contact->IsTouching() || a.IsSensor() || b.IsSensor()) continue;
        if (!isMovable(*a.GetBody()) || !isMovable(*b.GetBody())) continue;
        Demand(a.GetBody()->IsAwake() == b.GetBody()->IsAwake(), "who touches somebody awake is awake");
    }
    for (const scree::Joint* joint = world.GetJointList(); joint != nullptr; joint = joint->GetNext()) {
        const scree::Body &a = *joint->GetBodyA(), &b = *joint->GetBodyB();
        if (isMovable(a) && isMovable(b))
            Demand(a.IsAwake() == b.IsAwake(), "who is joined to somebody awake is awake");
    }
}

using FixturePair = std::pair<int, int>;  ///< by Fixture::GetIndex, the lower one first

inline FixturePair PairOf(const scree::Fixture& a, const scree::Fixture& b) {
    return std::minmax(a.GetIndex(), b.GetIndex());
}

/// Those with a contact; none twice.
inline std::set<FixturePair> PairsOfContacts(const scree::World& world) {
    std::set<FixturePair> pairs;
    for (const scree::Contact* contact = world.GetContactList(); contact != nullptr; contact = contact->GetNext()) {
        const bool isNew = pairs.insert(PairOf(*contact->GetFixtureA(), *contact->GetFixtureB())).second;
        Demand(isNew, "no pair has two contacts");
    }
    return pairs;
}

/// Box2D's rule for bodies.
inline bool MayCollide(const scree::World& world, const scree::Body& a, const scree::Body& b) {
    if (a.GetType() != scree::dynamicBody && b.GetType() != scree::dynamicBody) return false;
    for (const scree::Joint* joint = world.GetJointList(); joint != nullptr; joint = joint->GetNext()) {
        const bool joins = (joint->GetBodyA() == &a && joint->GetBodyB() == &b) ||
                           (joint->GetBodyA() == &b && joint->GetBodyB() == &a);
        if (joins && !joint->GetCollideConnected()) return false;
    }
    return true;
}

/// Edges and chains have no inside.
inline bool IsLine(const scree::Fixture& fixture) {
    return fixture.GetType() == scree::Shape::e_edge || fixture.GetType() == scree::Shape::e_chain;
}

/// After a step of no time, and so in the places in which contacts were looked at: who touches is as near as that.
inline void CheckTouching(const scree::World& world) {
    constexpr float tolerance = 0.01f;
    const auto isLooked = [](const scree::Body& body) {
        return body.GetType() != scree::staticBody && body.IsAwake() && body.IsEnabled();
    };
    for (const scree::Contact* contact = world.GetContactList(); contact != nullptr; contact = contact->GetNext()) {
        const scree::Fixture &a = *contact->GetFixtureA(), &b = *contact->GetFixtureB();
        if (IsLine(a) || IsLine(b) || !IsNear(a.GetAABB()) || !IsNear(b.GetAABB())) continue;
        if (!isLooked(*a.GetBody()) && !isLooked(*b.GetBody())) continue;
        scree::DistanceInput input;
        input.proxyA.Set(a.GetShape(), 0), input.proxyB.Set(b.GetShape(), 0);
        input.transformA = a.GetBody()->GetTransform(), input.transformB = b.GetBody()->GetTransform();
        input.useRadii = false;
        scree::SimplexCache cache;
        scree::DistanceOutput nearest;
        Distance(&nearest, &cache, &input);
        const float gap = nearest.distance - a.GetShape()->m_radius - b.GetShape()->m_radius;
        Demand(!contact->IsTouching() || gap <= tolerance, "who touches is near");
        Demand(contact->IsTouching() || gap >= -tolerance, "who is near touches");
    }
}

/// By brute force: who may collide and whose boxes overlap. In the fat tree boxes are fat.
inline std::set<FixturePair> PairsOfBoxes(const scree::World& world) {
    std::vector<const scree::Fixture*> fixtures;
    ForEachFixture(world, [&](const scree::Fixture& fixture) { fixtures.push_back(&fixture); });
    scree::ContactFilter filter;
    std::set<FixturePair> pairs;
    for (size_t i = 0; i < fixtures.size(); ++i) {
        for (size_t j = 0; j < i; ++j) {
            const scree::Fixture &a = *fixtures[i], &b = *fixtures[j];
            if (a.GetBody() == b.GetBody() || (IsLine(a) && IsLine(b)) || !TestOverlap(a.GetAABB(), b.GetAABB()))
                continue;
            if (!filter.ShouldCollide(const_cast<scree::Fixture*>(&a), const_cast<scree::Fixture*>(&b))) continue;
            if (MayCollide(world, *a.GetBody(), *b.GetBody())) pairs.insert(PairOf(a, b));
        }
    }
    return pairs;
}

/// After a step without callbacks that edit.
inline void CheckContacts(const scree::World& world) {
    const std::set<FixturePair> contacts = PairsOfContacts(world), boxes = PairsOfBoxes(world);
    Demand(std::ranges::includes(contacts, boxes), "boxes that overlap have a contact");
    for (const scree::Contact* contact = world.GetContactList(); contact != nullptr; contact = contact->GetNext()) {
        const bool overlap = boxes.contains(PairOf(*contact->GetFixtureA(), *contact->GetFixtureB()));
        Demand(overlap || contact->IsTouching(), "who has a contact touched or has boxes that overlap");
    }
}

}  // namespace fuzz
