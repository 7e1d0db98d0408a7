// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Views of a world's insides, for testbeds, debuggers and reports. Nothing here changes what a step computes.

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scree/api.h"
#include "scree/body.h"
#include "scree/bvh_node.h"
#include "scree/collision.h"
#include "scree/time_of_impact.h"
#include "scree/world.h"

namespace scree::inspect {

/// The broad-phase tree of the poses at the end of the last step: static and moving part joined under a virtual root,
/// one fixture per leaf. Empty for algorithms that keep no tree.
SCREE_API void GetNodes(const World& world, std::vector<BvhNode>& nodes);
/// Boxes per leaf of the production tree; 0 without a tree.
SCREE_API int GetLeafSize(const World& world);
/// True while static fixtures have a tree of their own.
SCREE_API bool IsStaticTreeSeparate(const World& world);
/// What the world was made with, and what was set since then.
SCREE_API const WorldDef& GetDefinition(const World& world);
/// The algorithm in use (`automatic` resolved).
SCREE_API BroadPhaseKind GetBroadPhase(const World& world);
/// Box–box comparisons of the last pair finding.
SCREE_API uint64_t GetBoxTests(const World& world);
/// Bodies and contacts that the next step will look at: those that are awake or were changed, those around them, and a
/// few that have just fallen asleep.
SCREE_API int GetListedCount(const World& world);
SCREE_API int GetActiveContactCount(const World& world);

/// Distance and time-of-impact searches of the last step: sensors and continuous collision.
SCREE_API const TOIStats& GetDistanceWork(const World& world);
/// By Contact::GetIndex: the colour in which the vector kernels solved a contact in the last step. It is −1 for
/// others: those that did not touch, sensors, and islands solved one by one. No two contacts of one colour act on the
/// same dynamic body. O(contacts).
SCREE_API void GetContactColours(const World& world, std::vector<int>& colours);

/// Bytes that each table keeps, room for more rows included. Scratch of all stages is `solverScratch`.
struct MemoryUse {
    size_t bodies = 0, fixtures = 0, contacts = 0, joints = 0, broadPhase = 0, solverScratch = 0;
    size_t bytesPerBody = 0, bytesPerFixture = 0, bytesPerContact = 0;  ///< of one record, solver scratch excluded
};
SCREE_API MemoryUse GetMemoryUse(const World& world);

/// Whether bodies without contacts and joints are integrated apart from the solver (the default) or by it, to measure
/// what that saves. Both give the same bits, except where continuous collision stops a body at a time of impact, where
/// they may differ.
SCREE_API void SetIsolatedPath(World& world, bool apart);

/// Whether the soft step solves joints directly where it can (the default), or all of them in turn, as it solves nets:
/// to measure what that gives. Images and recordings do not contain it.
SCREE_API void SetDirectJoints(World& world, bool direct);
SCREE_API bool GetDirectJoints(const World& world);

/// The values of a body for recorders, read at once.
struct BodyView {
    const Body* body;
    uint32_t generation;      ///< of its id
    FixtureId newestFixture;  ///< the first of its list; index −1: it has none
    BodyType type;
    bool isAwake;
    Vec2 position, linearVelocity;
    float angle, angularVelocity;
};
/// All bodies in the order of World::GetBodyList. O(bodies).
SCREE_API void GetBodies(const World& world, std::vector<BodyView>& bodies);

/// A touching contact in the same way: what its points follow from.
struct ContactView {
    int fixtureA, fixtureB;    ///< Fixture::GetIndex
    bool isSensor;             ///< one of them is
    float radiusA, radiusB;    ///< of the shapes
    Transform placeA, placeB;  ///< of the bodies, seen from `frame`
    Vec2 frame;
    Manifold manifold;  ///< without the ids of its points

    /// What Contact::GetWorldManifold gives; without points its normal is 0.
    SCREE_API WorldManifold GetPoints() const;
};

/// The contacts that touch at one moment, in the order of World::GetContactList. It holds its own copy, in few bytes,
/// so that a recorder can take it in every step and leave the rest to another thread.
class TouchingContacts {
public:
    /// Takes those of a world in place of what it held. O(bodies + contacts); allocates where they are more than ever.
    SCREE_API void Take(const World& world);
    [[nodiscard]] int Count() const { return m_count; }
    [[nodiscard]] size_t CountBytes() const { return m_used * sizeof(uint32_t) + m_places.size() * sizeof(Transform); }
    /// Calls visit(const ContactView&) for each.
    template <typename Visit>
    void ForEach(Visit&& visit) const {
        const uint32_t* at = m_words.data();
        for (int i = 0; i < m_count; ++i) visit(ViewAt(at));
    }

private:
    /// The contact whose words begin at `at`, which then is at those of the next one.
    SCREE_API ContactView ViewAt(const uint32_t*& at) const;

    std::vector<Transform> m_places;  ///< of the bodies by index; empty where contacts have frames of their own
    std::vector<uint32_t> m_words;
    size_t m_used = 0;
    int m_count = 0;
};

/// The kernels that the last step ran.
SCREE_API KernelSet GetKernels(const World& world);

/// 64 bits over all that steps and calls read: bodies, fixtures with shapes and boxes, contacts with impulses, joints,
/// settings, the orders of lists and which numbers are free. Equal hashes mean equal futures. Not in it: what changes
/// no result (workers, features, which broad phase with tight boxes), user data, listeners and filters. −0 and NaN
/// count as 0. O(size of the world).
SCREE_API uint64_t GetStateHash(const World& world);

}  // namespace scree::inspect
