// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Records worlds of Box2D 2.4.0 to 2.4.2 (C++11), for the program `scree` to look at elsewhere:
//
//   scree_capture::Track track(world, "session.track");    // once
//   world.Step(dt, 8, 3); track.Step(dt);                  // after every step
//   scree_capture::WriteScene(world, "level.scene.json");  // one moment
//
// A scene does not hold masses set by hand, restitution thresholds and disabled bodies. A body that was destroyed and
// another that was made at the same address between two steps may be taken for one. That happens if nothing else in the
// world's list changed; Track::Refresh tells them apart. With scree's headers for Box2D programs there are no nodes of
// the tree.

#pragma once

#include <box2d/box2d.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "scree_capture_track.h"

namespace scree_capture {
inline namespace box2d_engine {

/// Places of fixtures by their addresses: a hash table with open addressing.
class FixturePlaces {
public:
    void clear() {
        m_rows.clear();
        m_count = 0;
    }
    detail::Place& operator[](const b2Fixture* fixture) {
        if (2 * (m_count + 1) > m_rows.size()) Grow();
        Row& row = m_rows[Find(fixture)];
        if (row.fixture == nullptr) ++m_count;
        row.fixture = fixture;
        return row.place;
    }
    detail::Place At(const b2Fixture* fixture) const { return m_rows[Find(fixture)].place; }

private:
    struct Row {
        const b2Fixture* fixture;
        detail::Place place;
    };
    std::size_t Find(const b2Fixture* fixture) const {
        const std::uint64_t key = static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(fixture));
        std::size_t at = static_cast<std::size_t>(key * 0x9E3779B97F4A7C15u >> 32) & (m_rows.size() - 1);
        while (m_rows[at].fixture != nullptr && m_rows[at].fixture != fixture) at = (at + 1) & (m_rows.size() - 1);
        return at;
    }
    void Grow() {
        std::vector<Row> old(m_rows.empty() ? 64 : 2 * m_rows.size(), Row{nullptr, {-1, 0, 0}});
        old.swap(m_rows);
        for (std::size_t i = 0; i < old.size(); ++i) {
            if (old[i].fixture != nullptr) m_rows[Find(old[i].fixture)] = old[i];
        }
    }
    std::vector<Row> m_rows;
    std::size_t m_count = 0;
};

/// Stands in for a query's callback; carries what the walk through the tree needs.
struct NodeWalk {
    const FixturePlaces* places;
    detail::Bytes* bytes;
};

}  // namespace box2d_engine
}  // namespace scree_capture

#ifdef B2_DYNAMIC_TREE_H
/// b2DynamicTree keeps its nodes private, but a specialisation of its member template Query is a member.
template <>
inline void b2DynamicTree::Query<scree_capture::box2d_engine::NodeWalk>(scree_capture::box2d_engine::NodeWalk* walk,
                                                                        const b2AABB&) const {
    namespace detail = scree_capture::detail;
    std::vector<int32> pending;
    if (m_root != b2_nullNode) pending.push_back(m_root);
    detail::Bytes& bytes = *walk->bytes;
    const std::size_t used = bytes.size();
    bytes.resize(used + static_cast<std::size_t>(m_nodeCount) * detail::mostNodeBytes);
    unsigned char* out = bytes.data() + used;
    while (!pending.empty()) {
        const b2TreeNode& node = m_nodes[pending.back()];
        pending.pop_back();
        const float corners[4] = {node.aabb.lowerBound.x, node.aabb.lowerBound.y, node.aabb.upperBound.x,
                                  node.aabb.upperBound.y};
        if (node.IsLeaf()) {
            const b2FixtureProxy* proxy = static_cast<const b2FixtureProxy*>(node.userData);
            detail::Place place = walk->places->At(proxy->fixture);
            place.child = proxy->childIndex;
            out = detail::PutNode(out, corners, &place);
        } else {
            out = detail::PutNode(out, corners, nullptr);
            pending.push_back(node.child2);
            pending.push_back(node.child1);
        }
    }
    bytes.resize(static_cast<std::size_t>(out - bytes.data()));
}
#endif

namespace scree_capture {
inline namespace box2d_engine {

/// What the recorder asks of Box2D.
struct Api {
    typedef b2World World;
    typedef b2Body Body;
    typedef b2Fixture Fixture;
    typedef b2Joint Joint;
    typedef b2Contact Contact;
    typedef b2Manifold Manifold;
    typedef b2WorldManifold WorldManifold;
    typedef b2Shape Shape;
    typedef b2CircleShape Circle;
    typedef b2EdgeShape Edge;
    typedef b2PolygonShape Polygon;
    typedef b2Vec2 Vec2;
    typedef FixturePlaces Places;
    typedef detail::ListReader<Api> Reader;

    static const char* Writer() { return "scree_capture_box2d.h"; }
    /// Without the third number: 2.4.1 says that it is 2.4.0.
    static std::string Engine() {
        return "Box2D " + std::to_string(b2_version.major) + "." + std::to_string(b2_version.minor);
    }
    static int TypeOf(const Body& body) { return static_cast<int>(body.GetType()); }
    static float TangentSpeedOf(const b2Fixture&) { return 0.0f; }

    static std::uint64_t QuickIdentityOf(const World&, const Body& body) {
        return Mix(static_cast<std::uint64_t>(body.GetType()), body.GetFixtureList());
    }
    static std::uint64_t IdentityOf(const World&, const Body& body) {
        std::uint64_t hash = static_cast<std::uint64_t>(body.GetType());
        for (const Fixture* f = body.GetFixtureList(); f != nullptr; f = f->GetNext()) hash = Mix(hash, f);
        return hash;
    }
    static std::uint64_t IdentityOf(const World&, const Joint& joint) {
        Joint& asked = const_cast<Joint&>(joint);
        return Mix(Mix(static_cast<std::uint64_t>(joint.GetType()), asked.GetBodyA()), asked.GetBodyB());
    }
    static std::uint64_t CountObjects(const World& world) { return static_cast<std::uint64_t>(world.GetProxyCount()); }

    static void ReadState(const Body& body, detail::State& state) {
        const Vec2 &position = body.GetPosition(), &velocity = body.GetLinearVelocity();
        state.Set(position, body.GetAngle(), velocity, body.GetAngularVelocity());
        state.awake = body.GetType() != b2_staticBody && body.IsAwake();
    }

    /// The list has the newest first.
    static void SortByAge(std::vector<Body*>& bodies) { std::reverse(bodies.begin(), bodies.end()); }
    static bool GoOn(const Fixture&, const Fixture&) { return false; }

    template <typename Scene>
    static void WriteShape(Scene& scene, const std::vector<const Fixture*>& group) {
        if (group.front()->GetType() != b2Shape::e_chain) {
            detail::UsualShapes<Api, Scene>::Write(scene, *group.front()->GetShape());
            return;
        }
        const b2ChainShape& chain = static_cast<const b2ChainShape&>(*group.front()->GetShape());
        const Vec2* v = chain.m_vertices;
        const int count = chain.m_count;
        const bool isLoop =
            count >= 4 && v[0] == v[count - 1] && chain.m_prevVertex == v[count - 2] && chain.m_nextVertex == v[1];
        scene.Text("type", "chain");
        const Vec2 ghosts[] = {chain.m_prevVertex, chain.m_nextVertex};
        if (!isLoop) scene.Points("vertices", ghosts, 2);
        scene.Points("chainVertices", v, isLoop ? count - 1 : count);
    }

    static const char* NameOf(const Joint& joint) {
        switch (joint.GetType()) {
            case e_revoluteJoint:
                return "revolute";
            case e_prismaticJoint:
                return "prismatic";
            case e_pulleyJoint:
                return "pulley";
            case e_mouseJoint:
                return "mouse";
            case e_gearJoint:
                return "gear";
            case e_wheelJoint:
                return "wheel";
            case e_weldJoint:
                return "weld";
            case e_frictionJoint:
                return "friction";
            case e_motorJoint:
                return "motor";
            default:
                return "distance";
        }
    }

    template <typename Scene>
    static void WriteJoint(Scene& scene, Joint& joint, const detail::Numbers& joints) {
        switch (joint.GetType()) {
            case e_revoluteJoint:
                detail::WriteRevolute(scene, static_cast<const b2RevoluteJoint&>(joint));
                break;
            case e_prismaticJoint:
                detail::WritePrismatic(scene, static_cast<const b2PrismaticJoint&>(joint));
                break;
            case e_pulleyJoint:
                detail::WritePulley(scene, static_cast<b2PulleyJoint&>(joint));
                break;
            case e_mouseJoint:
                detail::WriteMouse(scene, static_cast<b2MouseJoint&>(joint));
                break;
            case e_gearJoint:
                detail::WriteGear(scene, static_cast<b2GearJoint&>(joint), joints);
                break;
            case e_wheelJoint:
                detail::WriteWheel(scene, static_cast<const b2WheelJoint&>(joint));
                break;
            case e_weldJoint:
                detail::WriteWeld(scene, static_cast<const b2WeldJoint&>(joint));
                break;
            case e_frictionJoint:
                detail::WriteFriction(scene, static_cast<const b2FrictionJoint&>(joint));
                break;
            case e_motorJoint:
                detail::WriteMotorJoint(scene, static_cast<const b2MotorJoint&>(joint));
                break;
            case e_distanceJoint: {
                const b2DistanceJoint& distance = static_cast<const b2DistanceJoint&>(joint);
                scene.Anchors(distance);
                WriteDistance(scene, distance, 0);
                scene.Spring(distance);
                break;
            }
            default:
#ifdef B2_ROPE_JOINT_H
                if (joint.GetType() == e_ropeJoint) {
                    const b2RopeJoint& rope = static_cast<const b2RopeJoint&>(joint);
                    scene.Anchors(rope);
                    detail::WriteLengths(scene, rope.GetMaxLength(), 0.0f, rope.GetMaxLength());
                }
#endif
                break;
        }
    }

    struct ContactSides {
        const Fixture *a, *b;
        std::int32_t childA, childB;
    };
    static ContactSides SidesOf(Contact& contact) {
        const ContactSides sides = {contact.GetFixtureA(), contact.GetFixtureB(), contact.GetChildIndexA(),
                                    contact.GetChildIndexB()};
        return sides;
    }
    static std::pair<detail::Place, detail::Place> PlacesOf(const ContactSides& sides, const Places& places) {
        std::pair<detail::Place, detail::Place> pair(places.At(sides.a), places.At(sides.b));
        pair.first.child = sides.childA;
        pair.second.child = sides.childB;
        return pair;
    }
    static const Manifold& ManifoldOf(const Contact& contact) { return *contact.GetManifold(); }

    static void WriteNodes(const World& world, const Places& places, detail::Bytes& bytes) {
#ifdef B2_DYNAMIC_TREE_H
        NodeWalk walk = {&places, &bytes};
        b2AABB unused;
        unused.lowerBound.SetZero();
        unused.upperBound.SetZero();
        world.GetContactManager().m_broadPhase.Query(&walk, unused);
#else
        (void)world;
        (void)places;
        (void)bytes;
#endif
    }

    static void WriteStages(const World& world, detail::CborWriter& out) {
        const b2Profile& profile = world.GetProfile();
        const std::pair<const char*, float> stages[] = {{"step", profile.step},
                                                        {"collide", profile.collide},
                                                        {"solve", profile.solve},
                                                        {"solveInit", profile.solveInit},
                                                        {"solveVelocity", profile.solveVelocity},
                                                        {"solvePosition", profile.solvePosition},
                                                        {"broadphase", profile.broadphase},
                                                        {"solveTOI", profile.solveTOI}};
        for (const std::pair<const char*, float>& stage : stages) {
            out.Key(stage.first);
            out.Value(stage.second);
        }
    }

private:
    static std::uint64_t Mix(std::uint64_t hash, const void* pointer) {
        return (hash ^ static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(pointer))) * 0x9E3779B97F4A7C15u;
    }

    /// From 2.4.1 on a distance joint has limits; before it was a rod or a spring.
    template <typename Scene, typename Any>
    static auto WriteDistance(Scene& scene, const Any& joint, int) -> decltype(joint.GetMinLength(), void()) {
        detail::WriteLengths(scene, joint.GetLength(), joint.GetMinLength(), joint.GetMaxLength());
    }
    template <typename Scene, typename Any>
    static void WriteDistance(Scene& scene, const Any& joint, long) {
        const bool isRod = !(joint.GetStiffness() > 0.0f);
        detail::WriteLengths(scene, joint.GetLength(), isRod ? joint.GetLength() : 0.0f,
                             isRod ? joint.GetLength() : FLT_MAX);
    }
};

typedef detail::BasicTrack<Api> Track;

/// Writes a world as a scene file; false if it cannot be written.
inline bool WriteScene(b2World& world, const std::string& path, const Options& options = Options()) {
    return detail::WriteSceneFile<Api>(world, path, options);
}

}  // namespace box2d_engine
}  // namespace scree_capture
