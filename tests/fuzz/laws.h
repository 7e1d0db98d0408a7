// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What holds of every world after a step, whatever was done to it. A fault here would be the same in every replay.

#pragma once

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "scree/scree.h"
#include "tests/fuzz/input.h"

namespace fuzz {

/// No state becomes NaN or infinite.
inline void CheckFinite(const scree::World& world) {
    for (const scree::Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
        const bool isFinite = body->GetPosition().IsValid() && std::isfinite(body->GetAngle()) &&
                              body->GetWorldCenter().IsValid() && body->GetLinearVelocity().IsValid() &&
                              std::isfinite(body->GetAngularVelocity());
        Demand(isFinite, "states stay finite");
    }
}

/// Of each fixture: it holds the shape, and in all but the fat tree no more. Not where some body, or its centre of
/// mass, is or was far out: there rounding decides.
inline void CheckBoxes(const scree::World& world, bool areTight) {
    constexpr float near = 1e4f, tolerance = 0.01f;
    const auto isNear = [](scree::Vec2 a) { return std::abs(a.x) < near && std::abs(a.y) < near; };
    for (const scree::Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
        if (!body->IsEnabled() || !isNear(body->GetWorldCenter())) continue;
        for (const scree::Fixture* f = body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
            const scree::AABB box = f->GetAABB();
            scree::AABB shape;
            f->GetShape()->ComputeAABB(&shape, body->GetTransform());
            if (!isNear(shape.lowerBound) || !isNear(shape.upperBound)) continue;
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

/// Queries find what a look at all fixtures finds, whatever was edited since the last step.
inline void CheckQueries(const scree::World& world, const scree::AABB& box, scree::Vec2 point) {
    std::set<const scree::Fixture*> boxes, points, foundBoxes, foundPoints;
    ForEachFixture(world, [&](const scree::Fixture& fixture) {
        if (TestOverlap(fixture.GetAABB(), box)) boxes.insert(&fixture);
        if (fixture.TestPoint(point)) points.insert(&fixture);
    });
    const auto addTo = [](std::set<const scree::Fixture*>& found) {
        return [&found](scree::Fixture* fixture) { return found.insert(fixture).second; };
    };
    if (world.QueryAABB(box, addTo(foundBoxes)) == scree::ErrorCode::ok)
        Demand(foundBoxes == boxes, "a box finds the boxes that overlap it");
    if (world.QueryPoint(point, addTo(foundPoints)) == scree::ErrorCode::ok)
        Demand(foundPoints == points, "a point finds the fixtures that contain it");
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
