// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Union-find for islands, greedy colouring for partitions.

#include "testbed/view/islands.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace testbed {

namespace {

using scenes::BodyType;

/// The body of a contact's fixture when a constraint may move it, else −1.
int FindDynamicBody(const Snapshot& snapshot, int fixture) {
    const int body = snapshot.fixtures[static_cast<size_t>(fixture)].body;
    return snapshot.bodies[static_cast<size_t>(body)].type == BodyType::dynamic ? body : -1;
}

bool IsSolved(const Snapshot& snapshot, const ContactState& contact) {
    return contact.touching && !snapshot.fixtures[static_cast<size_t>(contact.fixtureA)].sensor &&
           !snapshot.fixtures[static_cast<size_t>(contact.fixtureB)].sensor;
}

}  // namespace

std::vector<int> FindIslands(const Snapshot& snapshot) {
    std::vector<int> parents(snapshot.bodies.size());
    std::iota(parents.begin(), parents.end(), 0);
    const auto find = [&parents](int body) {
        while (parents[static_cast<size_t>(body)] != body) {
            int& parent = parents[static_cast<size_t>(body)];
            parent = parents[static_cast<size_t>(parent)];
            body = parent;
        }
        return body;
    };
    const auto isDynamic = [&snapshot](int body) {
        return snapshot.bodies[static_cast<size_t>(body)].type == BodyType::dynamic;
    };
    const auto join = [&](int bodyA, int bodyB) {
        if (!isDynamic(bodyA) || !isDynamic(bodyB)) return;
        const int a = find(bodyA), b = find(bodyB);
        parents[static_cast<size_t>(std::max(a, b))] = std::min(a, b);  // the root is the smallest index
    };
    for (const ContactState& contact : snapshot.contacts) {
        const FixtureState& a = snapshot.fixtures[static_cast<size_t>(contact.fixtureA)];
        const FixtureState& b = snapshot.fixtures[static_cast<size_t>(contact.fixtureB)];
        if (contact.touching && !a.sensor && !b.sensor) join(a.body, b.body);
    }
    for (const JointState& joint : snapshot.joints) join(joint.bodyA, joint.bodyB);
    std::vector<int> islands(parents.size(), -1);
    for (int body = 0; body < static_cast<int>(parents.size()); ++body) {
        if (isDynamic(body)) islands[static_cast<size_t>(body)] = find(body);
    }
    return islands;
}

Partitions FindPartitions(const Snapshot& snapshot) {
    Partitions partitions;
    for (const ContactState& contact : snapshot.contacts) {
        partitions.contactColors.push_back(contact.color);
        partitions.colorCount = std::max(partitions.colorCount, contact.color + 1);
    }
    partitions.fromEngine = partitions.colorCount > 0;
    if (partitions.fromEngine) return partitions;
    std::vector<std::vector<bool>> taken(snapshot.bodies.size());  // by body: its contacts' colours
    for (size_t i = 0; i < snapshot.contacts.size(); ++i) {
        const ContactState& contact = snapshot.contacts[i];
        if (!IsSolved(snapshot, contact)) continue;
        const std::array<int, 2> bodies{FindDynamicBody(snapshot, contact.fixtureA),
                                        FindDynamicBody(snapshot, contact.fixtureB)};
        const auto isTaken = [&](size_t color) {
            return std::any_of(bodies.begin(), bodies.end(), [&](int body) {
                if (body < 0) return false;
                const std::vector<bool>& colors = taken[static_cast<size_t>(body)];
                return color < colors.size() && colors[color];
            });
        };
        size_t color = 0;
        while (isTaken(color)) ++color;
        for (const int body : bodies) {
            if (body < 0) continue;
            std::vector<bool>& colors = taken[static_cast<size_t>(body)];
            colors.resize(std::max(colors.size(), color + 1), false);
            colors[color] = true;
        }
        partitions.contactColors[i] = static_cast<int>(color);
        partitions.colorCount = std::max(partitions.colorCount, static_cast<int>(color) + 1);
    }
    return partitions;
}

}  // namespace testbed
