// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The one interface of all broad-phase algorithms: boxes of fixtures in, overlapping pairs out. A PAIR is two fixtures
// of different bodies, at least one of them dynamic, whose closed boxes overlap. Tight algorithms report exactly the
// pairs of the boxes given; the fattened tree reports a superset.
//
// Every call of FindPairs reports the COMPLETE set of current pairs, each once. Their order depends only on the calls
// made before. Pairs of movers that rest, with each other and with statics, may be left out.

#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "scree/broad_phase_kind.h"
#include "scree/bvh_node.h"
#include "scree/function_ref.h"
#include "scree/math.h"
#include "scree/shape.h"

namespace scree {

class TaskPool;

/// What a body's motion type means to the broad phase.
enum class Motion : uint8_t { isStatic = 0, kinematic = 1, dynamic = 2 };

/// A pair of fixtures, by the caller's fixture index; a < b.
struct Pair {
    uint32_t a, b;
    friend bool operator==(const Pair&, const Pair&) = default;
    friend auto operator<=>(const Pair&, const Pair&) = default;
};

/// What FindPairs did in its last call, and rebuilds since then, for reports and scaling tests; counts, never clocks.
struct BroadPhaseStats {
    uint64_t boxTests = 0;        ///< box–box comparisons
    uint32_t rebuiltProxies = 0;  ///< proxies that went through a build (or a reinsertion)
    bool staticTreeSeparate = false;
};

/// Knobs shared by the algorithms.
struct BroadPhaseConfig {
    /// Fixtures that rest, statics and sleepers, get a tree of their own above this share of all fixtures.
    float staticShareThreshold = 1.0f / 8.0f;
    /// Most boxes in a leaf where the algorithm allows more than one; 0: the algorithm's own best.
    int leafSize = 0;
    /// Factor on the margin of `fat-tree`.
    float lengthScale = 1.0f;
};

/// Below this many boxes the work of FindPairs stays on one thread.
inline constexpr uint32_t leastBoxesToShare = 2048;

/// Input of Update.
struct BoxUpdate {
    AABB box;
    Vec2 displacement;
    uint32_t fixture;
};

/// Called with a fixture; false ends the query.
using Visitor = FunctionRef<bool(uint32_t)>;
/// Called with what is left of the ray and a fixture; returns the new maxFraction. 0 ends the cast. A negative value
/// ignores the fixture and leaves the ray as it is.
using RayVisitor = FunctionRef<float(const RayCastInput&, uint32_t)>;

class BroadPhase {
public:
    virtual ~BroadPhase() = default;

    /// Adds the box of a fixture. `fixture` is any index that is not in use here (dense small numbers are fastest);
    /// `body` tells fixtures of one body, which never pair. O(1): structures are rebuilt lazily. Preconditions, checked
    /// by the caller: box valid, fixture not present.
    virtual void Insert(uint32_t fixture, uint32_t body, Motion motion, const AABB& box) = 0;
    /// Insert with the box that GetBox had given, taken as it is: FindPairs then reports the pairs it would have.
    virtual void Restore(uint32_t fixture, uint32_t body, Motion motion, const AABB& box) {
        Insert(fixture, body, motion, box);
    }
    /// Gives the fixture a new box; `displacement` is its body's motion since the last update (the fattened tree looks
    /// ahead along it). O(1) except in the fattened tree (O(log n) when the box leaves its margin).
    virtual void Update(uint32_t fixture, const AABB& box, Vec2 displacement) = 0;
    /// Whether displacements matter; if not, any may be given.
    [[nodiscard]] virtual bool UsesDisplacement() const { return false; }
    /// Update for many fixtures, in this order.
    virtual void UpdateMany(std::span<const BoxUpdate> updates) {
        for (const BoxUpdate& update : updates) Update(update.fixture, update.box, update.displacement);
    }
    /// Gives a fixture a box that covers its way, for queries up to the next update. That update leaves what it would
    /// have left without.
    virtual void CoverWay(uint32_t fixture, const AABB& way) { Update(fixture, way, vec2Zero); }
    /// CoverWay for many fixtures, in this order.
    virtual void CoverWays(std::span<const BoxUpdate> ways) { UpdateMany(ways); }
    /// Whether UpdateMoving is there for what moves.
    [[nodiscard]] virtual bool SharesUpdates() const { return false; }
    /// Update for fixtures that move and do not rest; several threads may call it at once for different fixtures.
    /// Returns whether any box is another one, which NoteUpdated must then be told once.
    [[nodiscard]] virtual bool UpdateMoving(std::span<const BoxUpdate> /*updates*/) { return false; }
    virtual void NoteUpdated(bool /*haveChanged*/) {}
    /// O(1).
    virtual void Remove(uint32_t fixture) = 0;
    /// A mover's fixture rests: its box will stay where it is for some time. Or does so no longer. O(1).
    virtual void SetResting(uint32_t /*fixture*/, bool /*resting*/) {}
    /// False if every fixture and box is what it was when FindPairs was called last.
    [[nodiscard]] virtual bool HasChanged() const { return true; }
    /// Lets FindPairs share its work, which leaves every result as it is. The pool must outlive the calls of FindPairs.
    virtual void ShareWork(TaskPool& /*pool*/) {}
    /// Writes the complete pair set into `pairs` (cleared first).
    virtual void FindPairs(std::vector<Pair>& pairs) = 0;

    /// Rebuilds what edits have made stale. Queries answer right without it, but scan what is stale.
    virtual void PrepareQueries() {}
    /// Visits every fixture whose stored box overlaps `box`. Returns the number of box tests. Queries and ray casts
    /// read only: any number of threads may ask while nobody edits.
    virtual uint64_t Query(const AABB& box, Visitor visit) const = 0;
    /// Visits fixtures whose stored box may be hit by a box of this half size whose centre goes along the ray; trees
    /// show those of near nodes first. Otherwise the same.
    virtual uint64_t CastBox(const RayCastInput& path, Vec2 halfSize, RayVisitor visit) const = 0;
    /// The same of a point.
    uint64_t RayCast(const RayCastInput& input, RayVisitor visit) const { return CastBox(input, vec2Zero, visit); }
    /// Rebuilds what QueryStatic needs and edits have made stale. Without it that scans what is stale.
    virtual void PrepareStatic() {}
    /// Query for static fixtures: visits all of them, and any movers too if that is cheaper than to leave them out.
    virtual uint64_t QueryStatic(const AABB& box, Visitor visit) const { return Query(box, visit); }

    /// Query for what rests, likewise: visits all movers that rest, and anything else too if that is cheaper than to
    /// leave it out.
    virtual void QueryResting(const AABB& box, Visitor visit) {
        PrepareQueries();
        Query(box, visit);
    }

    /// The stored box (tight, or fattened in `fat-tree`).
    [[nodiscard]] virtual AABB GetBox(uint32_t fixture) const = 0;
    [[nodiscard]] virtual int GetProxyCount() const = 0;
    /// The tree(s) as one, children after parents, static and moving part joined under a virtual root; empty for
    /// algorithms without a tree. Rebuilds lazily after edits.
    virtual void GetNodes(std::vector<BvhNode>& nodes) = 0;
    /// Boxes per leaf in use, 0 without a tree.
    [[nodiscard]] virtual int GetLeafSize() const = 0;
    [[nodiscard]] virtual size_t GetMemoryBytes() const = 0;
    [[nodiscard]] virtual BroadPhaseStats GetStats() const = 0;
};

/// Makes an algorithm; BroadPhaseKind::automatic gives the fastest one that keeps a tree.
std::unique_ptr<BroadPhase> CreateBroadPhase(BroadPhaseKind kind, const BroadPhaseConfig& config = {});

}  // namespace scree
