// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Records worlds of this engine, for the program `scree` to look at elsewhere:
//
//   scree_capture::Track track(world, "session.track");  // once
//   world.Step(dt, 8, 3); track.Step(dt);                // after every step
//   scree_capture::WriteScene(world, "level.scene.json");  // one moment
//
// A scene does not hold what Box2D 2.4.1 does not tell: masses set by hand, restitution thresholds, low-order parts of
// positions. Nor does it hold locks of motion along x and y, rolling resistance and mixing rules. It leaves out springs
// of hinges and sliders, thresholds of joints, and categories above the 16th. Disabled bodies are enabled there. Images
// and recordings hold all of it. Shapes with arcs (ellipses, sectors, support functions) become polygons.

#pragma once

#include <scree/inspect.h>
#include <scree/scree.h>

#include "scree_capture_track.h"

namespace scree_capture {
inline namespace own_engine {

/// What the recorder asks of this engine.
struct Api {
    typedef scree::World World;
    typedef scree::Body Body;
    typedef scree::Fixture Fixture;
    typedef scree::Joint Joint;
    typedef scree::Shape Shape;
    typedef scree::CircleShape Circle;
    typedef scree::EdgeShape Edge;
    typedef scree::PolygonShape Polygon;
    typedef scree::Vec2 Vec2;

    /// Places of fixtures by their dense numbers.
    class Places {
    public:
        void clear() { m_places.clear(); }
        detail::Place& operator[](const Fixture* fixture) {
            const auto index = static_cast<std::size_t>(fixture->GetIndex());
            if (m_places.size() <= index) m_places.resize(index + 1);
            return m_places[index];
        }
        [[nodiscard]] const detail::Place& At(int fixture) const { return m_places[static_cast<std::size_t>(fixture)]; }

    private:
        std::vector<detail::Place> m_places;
    };

    /// Reads bodies and contacts at once: one by one they take longer than their share of a step.
    class Reader {
    public:
        bool ReadBodies(const World& world, const std::vector<detail::BodySlot<Body>>& slots,
                        std::vector<detail::State>& now) {
            scree::inspect::GetBodies(world, m_bodies);
            if (m_bodies.size() != slots.size()) return false;
            for (std::size_t k = 0; k < slots.size(); ++k) {
                const scree::inspect::BodyView& b = m_bodies[k];
                if (slots[k].body != b.body) return false;
                if (slots[k].quick != QuickIdentityOf(b.generation, b.type, b.newestFixture)) return false;
                now[k].Set(b.position, b.angle, b.linearVelocity, b.angularVelocity);
                now[k].awake = b.type != scree::staticBody && b.isAwake;
            }
            return true;
        }
        typedef scree::inspect::TouchingContacts Contacts;
        static void ReadContacts(const World& world, Contacts& contacts) { contacts.Take(world); }
        static std::size_t CountBytes(const Contacts& contacts) { return contacts.CountBytes(); }
        static void Pack(const Contacts& contacts, const Places& places, detail::Bytes& bytes) {
            detail::ContactBytes out(bytes);
            contacts.ForEach([&](const scree::inspect::ContactView& c) {
                const scree::WorldManifold world = c.GetPoints();
                const int count = c.manifold.pointCount;
                unsigned char* end = out.Begin(places.At(c.fixtureA), places.At(c.fixtureB), count, c.isSensor,
                                               world.normal.x, world.normal.y);
                for (int i = 0; i < count; ++i) {
                    const scree::ManifoldPoint& point = c.manifold.points[i];
                    end = detail::PutFloat(detail::PutFloat(end, world.points[i].x), world.points[i].y);
                    end = detail::PutFloat(end, world.separations[i]);
                    end = detail::PutFloat(detail::PutFloat(end, point.normalImpulse), point.tangentImpulse);
                }
                out.End(end);
            });
        }

    private:
        std::vector<scree::inspect::BodyView> m_bodies;
    };

    static const char* Writer() { return "scree_capture.h"; }
    static std::string Engine() { return "scree"; }
    static int TypeOf(const Body& body) { return body.GetType(); }
    static float TangentSpeedOf(const Fixture& fixture) { return fixture.GetTangentSpeed(); }

    static std::uint64_t QuickIdentityOf(std::uint32_t generation, int type, scree::FixtureId newest) {
        const std::uint64_t own = std::uint64_t{generation} << 8 | static_cast<unsigned>(type);
        return newest.index < 0 ? own : Mix(own, newest);
    }
    static std::uint64_t QuickIdentityOf(const World& world, const Body& body) {
        const Fixture* newest = body.GetFixtureList();
        return QuickIdentityOf(world.GetId(&body).generation, body.GetType(),
                               newest == nullptr ? scree::FixtureId{} : world.GetId(newest));
    }
    static std::uint64_t IdentityOf(const World& world, const Body& body) {
        std::uint64_t hash = QuickIdentityOf(world, body);
        for (const Fixture* f = body.GetFixtureList(); f != nullptr; f = f->GetNext()) {
            hash = Mix(hash, world.GetId(f));
        }
        return hash;
    }
    static std::uint64_t IdentityOf(const World& world, const Joint& joint) { return world.GetId(&joint).generation; }
    static std::uint64_t CountObjects(const World& world) {
        return static_cast<std::uint64_t>(world.GetFixtureCount());
    }

    static void ReadState(const Body& body, detail::State& state) {
        const Vec2 position = body.GetPosition(), velocity = body.GetLinearVelocity();
        state.Set(position, body.GetAngle(), velocity, body.GetAngularVelocity());
        state.awake = body.GetType() != scree::staticBody && body.IsAwake();
    }

    /// Slots are taken in order while nothing is destroyed.
    static void SortByAge(std::vector<Body*>& bodies) {
        std::sort(bodies.begin(), bodies.end(),
                  [](const Body* a, const Body* b) { return a->GetIndex() < b->GetIndex(); });
    }

    static bool GoOn(const Fixture& before, const Fixture& after) {
        return before.GetChainId() >= 0 && before.GetChainId() == after.GetChainId() &&
               after.GetChainIndex() == before.GetChainIndex() + 1;
    }

    template <typename Scene>
    static void WriteShape(Scene& scene, const std::vector<const Fixture*>& group) {
        const Fixture& fixture = *group.front();
        if (fixture.GetChainId() >= 0) {
            WriteChain(scene, group);
        } else if (fixture.GetType() == Shape::e_convex) {
            WriteConvex(scene, static_cast<const scree::ConvexShape&>(*fixture.GetShape()));
        } else {
            detail::UsualShapes<Api, Scene>::Write(scene, *fixture.GetShape());
        }
    }

    static const char* NameOf(const Joint& joint) {
        switch (joint.GetType()) {
            case scree::e_revoluteJoint:
                return "revolute";
            case scree::e_prismaticJoint:
                return "prismatic";
            case scree::e_pulleyJoint:
                return "pulley";
            case scree::e_mouseJoint:
                return "mouse";
            case scree::e_gearJoint:
                return "gear";
            case scree::e_wheelJoint:
                return "wheel";
            case scree::e_weldJoint:
                return "weld";
            case scree::e_frictionJoint:
                return "friction";
            case scree::e_motorJoint:
                return "motor";
            default:
                return "distance";
        }
    }

    template <typename Scene>
    static void WriteJoint(Scene& scene, Joint& joint, const detail::Numbers& joints) {
        switch (joint.GetType()) {
            case scree::e_revoluteJoint:
                detail::WriteRevolute(scene, static_cast<const scree::RevoluteJoint&>(joint));
                break;
            case scree::e_prismaticJoint:
                detail::WritePrismatic(scene, static_cast<const scree::PrismaticJoint&>(joint));
                break;
            case scree::e_pulleyJoint:
                detail::WritePulley(scene, static_cast<scree::PulleyJoint&>(joint));
                break;
            case scree::e_mouseJoint:
                detail::WriteMouse(scene, static_cast<scree::MouseJoint&>(joint));
                break;
            case scree::e_gearJoint:
                detail::WriteGear(scene, static_cast<scree::GearJoint&>(joint), joints);
                break;
            case scree::e_wheelJoint:
                detail::WriteWheel(scene, static_cast<const scree::WheelJoint&>(joint));
                break;
            case scree::e_weldJoint:
                detail::WriteWeld(scene, static_cast<const scree::WeldJoint&>(joint));
                break;
            case scree::e_frictionJoint:
                detail::WriteFriction(scene, static_cast<const scree::FrictionJoint&>(joint));
                break;
            case scree::e_motorJoint:
                detail::WriteMotorJoint(scene, static_cast<const scree::MotorJoint&>(joint));
                break;
            default: {
                const auto& distance = static_cast<const scree::DistanceJoint&>(joint);
                scene.Anchors(distance);
                detail::WriteLengths(scene, distance.GetLength(), distance.GetMinLength(), distance.GetMaxLength());
                scene.Spring(distance);
                break;
            }
        }
    }

    static void WriteNodes(const World& world, const Places& places, detail::Bytes& bytes) {
        std::vector<scree::BvhNode> nodes;
        scree::inspect::GetNodes(world, nodes);
        std::vector<std::int32_t> pending;
        if (!nodes.empty()) pending.push_back(0);
        const std::size_t used = bytes.size();
        bytes.resize(used + nodes.size() * detail::mostNodeBytes);
        unsigned char* out = bytes.data() + used;
        while (!pending.empty()) {
            const scree::BvhNode& node = nodes[static_cast<std::size_t>(pending.back())];
            pending.pop_back();
            const Vec2 lower = node.box.lowerBound, upper = node.box.upperBound;
            if (node.fixture >= 0) {
                const detail::Place place = places.At(node.fixture);
                out = detail::PutNode(out, {lower.x, lower.y, upper.x, upper.y}, &place);
            } else {
                out = detail::PutNode(out, {lower.x, lower.y, upper.x, upper.y}, nullptr);
                pending.push_back(node.child2);
                pending.push_back(node.child1);
            }
        }
        bytes.resize(static_cast<std::size_t>(out - bytes.data()));
    }

    static void WriteStages(const World& world, detail::CborWriter& out) {
        const scree::Profile& profile = world.GetProfile();
        const std::pair<const char*, float> stages[] = {
            {"step", profile.step},       {"broadPhase", profile.broadPhase}, {"narrowPhase", profile.narrowPhase},
            {"islands", profile.islands}, {"solver", profile.solver},         {"continuous", profile.continuous}};
        for (const auto& [name, milliseconds] : stages) {
            out.Key(name);
            out.Value(milliseconds);
        }
    }

private:
    static std::uint64_t Mix(std::uint64_t hash, scree::FixtureId id) {
        return (hash ^ (std::uint64_t{id.generation} << 32 | static_cast<std::uint32_t>(id.index))) *
               0x9E3779B97F4A7C15u;
    }
    template <typename Scene>
    static void WriteChain(Scene& scene, const std::vector<const Fixture*>& group) {
        std::vector<const Edge*> edges;
        for (const Fixture* fixture : group) edges.push_back(static_cast<const Edge*>(fixture->GetShape()));
        const Edge &first = *edges.front(), &last = *edges.back();
        const bool isLoop = edges.size() >= 3 && last.m_vertex2 == first.m_vertex1 &&
                            first.m_vertex0 == last.m_vertex1 && last.m_vertex3 == first.m_vertex2;
        std::vector<Vec2> vertices;
        for (const Edge* edge : edges) vertices.push_back(edge->m_vertex1);
        if (!isLoop) vertices.push_back(last.m_vertex2);
        scene.Text("type", "chain");
        const Vec2 ghosts[] = {first.m_vertex0, last.m_vertex3};
        if (!isLoop) scene.Points("vertices", ghosts, 2);
        scene.Points("chainVertices", vertices.data(), static_cast<int>(vertices.size()));
    }

    template <typename Scene>
    static void WriteConvex(Scene& scene, const scree::ConvexShape& shape) {
        if (shape.m_curvedSides == 0 && shape.m_solidRadius > 0.0f && shape.m_count <= scree::maxPolygonVertices) {
            const bool isCapsule = shape.m_count <= 2;
            const Vec2 ends[] = {shape.m_vertices[0], shape.m_vertices[shape.m_count - 1]};
            scene.Text("type", isCapsule ? "capsule" : "roundedPolygon");
            scene.Number("radius", shape.m_solidRadius, 0.0f);
            scene.Points("vertices", isCapsule ? ends : shape.m_vertices, isCapsule ? 2 : shape.m_count);
            return;
        }
        // Arcs become two chords each while there is room.
        const bool isHalved = 2 * shape.m_count <= scree::maxConvexVertices;
        std::vector<Vec2> vertices;
        for (int i = 0; i < shape.m_count; ++i) {
            const Vec2 from = shape.m_vertices[i], to = shape.m_vertices[(i + 1) % shape.m_count];
            vertices.push_back(from);
            if (isHalved && shape.IsCurved(i)) {
                vertices.push_back(0.25f * (from + to) + 0.5f * shape.m_controls[i]);
            }
        }
        scene.Text("type", "largePolygon");
        scene.Points("chainVertices", vertices.data(), static_cast<int>(vertices.size()));
    }
};

typedef detail::BasicTrack<Api> Track;

/// Writes a world as a scene file; false if it cannot be written.
inline bool WriteScene(scree::World& world, const std::string& path, const Options& options = Options()) {
    return detail::WriteSceneFile<Api>(world, path, options);
}

}  // namespace own_engine
}  // namespace scree_capture
