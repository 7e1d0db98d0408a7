// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What is common to all joints, their lists, and the drawing of those without a picture of their own.

#include "../box2d/b2_joint.h"

#include "convert.h"
#include "world_data.h"

using namespace scree::box2d;

namespace {

void LinkEdge(b2JointEdge*& list, b2JointEdge& edge) {
    edge.prev = nullptr;
    edge.next = list;
    if (list != nullptr) list->prev = &edge;
    list = &edge;
}

void UnlinkEdge(b2JointEdge*& list, b2JointEdge& edge) {
    if (edge.prev != nullptr) edge.prev->next = edge.next;
    if (edge.next != nullptr) edge.next->prev = edge.prev;
    if (list == &edge) list = edge.next;
}

}  // namespace

void b2Bridge::Link(b2WorldData& data, b2Joint* joint) {
    joint->m_prev = nullptr;
    joint->m_next = data.joints;
    if (data.joints != nullptr) data.joints->m_prev = joint;
    data.joints = joint;
    joint->m_edgeA.joint = joint->m_edgeB.joint = joint;
    joint->m_edgeA.other = joint->m_bodyB;
    joint->m_edgeB.other = joint->m_bodyA;
    LinkEdge(joint->m_bodyA->m_jointList, joint->m_edgeA);
    LinkEdge(joint->m_bodyB->m_jointList, joint->m_edgeB);
}

void b2Bridge::FreeJoint(b2WorldData& data, b2Joint* joint) {
    if (joint->m_prev != nullptr) joint->m_prev->m_next = joint->m_next;
    if (joint->m_next != nullptr) joint->m_next->m_prev = joint->m_prev;
    if (data.joints == joint) data.joints = joint->m_next;
    UnlinkEdge(joint->m_bodyA->m_jointList, joint->m_edgeA);
    UnlinkEdge(joint->m_bodyB->m_jointList, joint->m_edgeB);
    delete joint;
}

b2JointType b2Joint::GetType() const { return m_type; }
b2Body* b2Joint::GetBodyA() { return m_bodyA; }
b2Body* b2Joint::GetBodyB() { return m_bodyB; }
b2Vec2 b2Joint::GetAnchorA() const { return ToBox2d(m_handle->GetAnchorA()); }
b2Vec2 b2Joint::GetAnchorB() const { return ToBox2d(m_handle->GetAnchorB()); }
b2Vec2 b2Joint::GetReactionForce(float inv_dt) const { return ToBox2d(m_handle->GetReactionForce(inv_dt)); }
float b2Joint::GetReactionTorque(float inv_dt) const { return m_handle->GetReactionTorque(inv_dt); }
b2Joint* b2Joint::GetNext() { return m_next; }
const b2Joint* b2Joint::GetNext() const { return m_next; }
b2JointUserData& b2Joint::GetUserData() { return m_userData; }
bool b2Joint::IsEnabled() const { return m_bodyA->IsEnabled() && m_bodyB->IsEnabled(); }
bool b2Joint::GetCollideConnected() const { return m_handle->GetCollideConnected(); }
void b2Joint::Dump() { b2Dump("// scree writes no dump of joints\n"); }
void b2Joint::ShiftOrigin(const b2Vec2& newOrigin) { m_handle->ShiftOrigin(ToScree(newOrigin)); }

void b2Joint::Draw(b2Draw* draw) const {
    const b2Vec2 anchorA = GetAnchorA();
    const b2Vec2 anchorB = GetAnchorB();
    const b2Color color(0.5f, 0.8f, 0.8f);
    switch (m_type) {
        case e_pulleyJoint: {
            const auto& pulley = static_cast<const b2PulleyJoint&>(*this);
            draw->DrawSegment(pulley.GetGroundAnchorA(), anchorA, color);
            draw->DrawSegment(pulley.GetGroundAnchorB(), anchorB, color);
            draw->DrawSegment(pulley.GetGroundAnchorA(), pulley.GetGroundAnchorB(), color);
            break;
        }
        case e_mouseJoint:
            draw->DrawPoint(anchorA, 4.0f, b2Color(0.0f, 1.0f, 0.0f));
            draw->DrawPoint(anchorB, 4.0f, b2Color(0.0f, 1.0f, 0.0f));
            draw->DrawSegment(anchorA, anchorB, b2Color(0.8f, 0.8f, 0.8f));
            break;
        default:
            draw->DrawSegment(m_bodyA->GetPosition(), anchorA, color);
            draw->DrawSegment(anchorA, anchorB, color);
            draw->DrawSegment(m_bodyB->GetPosition(), anchorB, color);
    }
}

void b2LinearStiffness(float& stiffness, float& damping, float frequencyHertz, float dampingRatio, const b2Body* bodyA,
                       const b2Body* bodyB) {
    scree::LinearStiffness(stiffness, damping, frequencyHertz, dampingRatio, b2Bridge::Handle(bodyA),
                           b2Bridge::Handle(bodyB));
}

void b2AngularStiffness(float& stiffness, float& damping, float frequencyHertz, float dampingRatio, const b2Body* bodyA,
                        const b2Body* bodyB) {
    scree::AngularStiffness(stiffness, damping, frequencyHertz, dampingRatio, b2Bridge::Handle(bodyA),
                            b2Bridge::Handle(bodyB));
}
