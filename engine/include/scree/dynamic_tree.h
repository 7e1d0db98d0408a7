// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A stand-alone tree of boxes for programs that need spatial queries of their own: Box2D 2.4's b2DynamicTree, on the
// same code as the broad phase `fat-tree`. Boxes in, proxy numbers out.

#pragma once

#include <memory>

#include "scree/api.h"
#include "scree/function_ref.h"
#include "scree/math.h"
#include "scree/settings.h"
#include "scree/shape.h"

namespace scree {

/// Boxes are kept fattened by a margin, so that a proxy which moves a little needs no work. A call with a proxy
/// that does not exist, or with a box that is not valid, changes nothing and returns what is stated.
class SCREE_API DynamicTree {
public:
    /// `margin`: m on each side, ≥ 0; another value gives the default one.
    explicit DynamicTree(float margin = aabbExtension);
    ~DynamicTree();
    DynamicTree(DynamicTree&&) noexcept;
    DynamicTree& operator=(DynamicTree&&) noexcept;

    /// Adds a box; returns its proxy, or −1 if the box is not valid. O(log n).
    int CreateProxy(const AABB& aabb, void* userData);
    /// False if there is no such proxy.
    bool DestroyProxy(int proxy);
    /// Gives a proxy a new tight box; `displacement` stretches the fat one ahead. True if it left its fat box and was
    /// inserted anew.
    bool MoveProxy(int proxy, const AABB& aabb, Vec2 displacement);
    /// Null if there is no such proxy.
    [[nodiscard]] void* GetUserData(int proxy) const;
    /// True from creation or reinsertion until ClearMoved.
    [[nodiscard]] bool WasMoved(int proxy) const;
    void ClearMoved(int proxy);
    /// The fattened box; an empty one at the origin if there is no such proxy. Valid until the tree changes.
    [[nodiscard]] AABB GetFatAABB(int proxy) const;

    /// Calls visit(proxy) for each proxy whose fat box overlaps, until it returns false. The tree must not change
    /// meanwhile.
    void Query(const AABB& aabb, FunctionRef<bool(int)> visit) const;
    /// Calls visit(input, proxy) for each proxy whose fat box the ray may hit. It returns the new maxFraction, 0 to
    /// stop, a negative number to leave the ray as it is.
    void RayCast(const RayCastInput& input, FunctionRef<float(const RayCastInput&, int)> visit) const;

    /// True if links, heights and boxes are consistent. O(n).
    [[nodiscard]] bool Validate() const;
    [[nodiscard]] int GetProxyCount() const;
    /// Levels below the root; 0 for an empty tree.
    [[nodiscard]] int GetHeight() const;
    /// Largest difference in height of two siblings. O(n).
    [[nodiscard]] int GetMaxBalance() const;
    /// Sum of all perimeters over the root's. O(n).
    [[nodiscard]] float GetAreaRatio() const;
    /// Joins the cheapest pair again and again: O(n³), for tests. Proxies keep their numbers.
    void RebuildBottomUp();
    /// Subtracts `newOrigin` from every box. O(n).
    void ShiftOrigin(Vec2 newOrigin);

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

}  // namespace scree
