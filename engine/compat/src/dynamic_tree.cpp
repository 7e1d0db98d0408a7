// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// b2DynamicTree is the engine's DynamicTree; only boxes are kept beside it, because Box2D returns them by reference.

#include "../box2d/b2_dynamic_tree.h"

#include <deque>

#include "convert.h"
#include "scree/dynamic_tree.h"

struct b2TreeData {
    scree::DynamicTree tree{b2_aabbExtension};
    mutable std::deque<b2AABB> boxes;  ///< by proxy id; references to them stay valid
};

using namespace scree::box2d;

b2DynamicTree::b2DynamicTree() : m_data(std::make_unique<b2TreeData>()) {}
b2DynamicTree::~b2DynamicTree() = default;

void b2DynamicTree::Clear() { m_data = std::make_unique<b2TreeData>(); }

int32 b2DynamicTree::CreateProxy(const b2AABB& aabb, void* userData) {
    return m_data->tree.CreateProxy(ToScree(aabb), userData);
}
void b2DynamicTree::DestroyProxy(int32 proxyId) { m_data->tree.DestroyProxy(proxyId); }
bool b2DynamicTree::MoveProxy(int32 proxyId, const b2AABB& aabb1, const b2Vec2& displacement) {
    return m_data->tree.MoveProxy(proxyId, ToScree(aabb1), ToScree(displacement));
}
void* b2DynamicTree::GetUserData(int32 proxyId) const { return m_data->tree.GetUserData(proxyId); }
bool b2DynamicTree::WasMoved(int32 proxyId) const { return m_data->tree.WasMoved(proxyId); }
void b2DynamicTree::ClearMoved(int32 proxyId) { m_data->tree.ClearMoved(proxyId); }

const b2AABB& b2DynamicTree::GetFatAABB(int32 proxyId) const {
    const size_t row = proxyId < 0 ? 0 : static_cast<size_t>(proxyId) + 1;  // row 0 answers for ids that do not exist
    if (m_data->boxes.size() <= row) m_data->boxes.resize(row + 1);
    m_data->boxes[row] = ToBox2d(m_data->tree.GetFatAABB(proxyId));
    return m_data->boxes[row];
}

void b2DynamicTree::VisitBoxes(const b2AABB& aabb, bool (*visit)(void*, int32), void* context) const {
    m_data->tree.Query(ToScree(aabb), [&](int proxy) { return visit(context, proxy); });
}

void b2DynamicTree::VisitRay(const b2RayCastInput& input, float (*visit)(void*, const b2RayCastInput&, int32),
                             void* context) const {
    m_data->tree.RayCast(ToScree(input), [&](const scree::RayCastInput& part, int proxy) {
        return visit(context, ToBox2d(part), proxy);
    });
}

void b2DynamicTree::Validate() const {
    if (!m_data->tree.Validate()) Complain("b2DynamicTree::Validate", "the tree is damaged");
}
int32 b2DynamicTree::GetHeight() const { return m_data->tree.GetHeight(); }
int32 b2DynamicTree::GetMaxBalance() const { return m_data->tree.GetMaxBalance(); }
float b2DynamicTree::GetAreaRatio() const { return m_data->tree.GetAreaRatio(); }
void b2DynamicTree::RebuildBottomUp() { m_data->tree.RebuildBottomUp(); }
void b2DynamicTree::ShiftOrigin(const b2Vec2& newOrigin) { m_data->tree.ShiftOrigin(ToScree(newOrigin)); }
