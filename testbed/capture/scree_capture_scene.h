// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A world whose interface is that of Box2D 2.4 (Box2D's own, or our engine's) as a scene: bodies with their fixtures,
// and joints, with the keys of scene files. `Api` names the engine's types and what differs between engines;
// `Writer` is CborWriter or JsonWriter. What has its default is left out.

#pragma once

#include <algorithm>
#include <cfloat>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "scree_capture_format.h"

namespace scree_capture {
namespace detail {

/// By which number a track calls a body or a joint.
typedef std::unordered_map<const void*, std::int64_t> Numbers;

/// User data of either form: a pointer, or a struct that holds one.
inline std::uint64_t ToNumber(const void* pointer) { return reinterpret_cast<std::uintptr_t>(pointer); }
template <typename Data>
std::uint64_t ToNumber(const Data& data) {
    return static_cast<std::uint64_t>(data.pointer);
}

/// Larger ones are no numbers that JSON's readers keep.
static const std::uint64_t mostUserData = std::uint64_t(1) << 53;

template <typename Api, typename Writer>
class SceneWriter {
public:
    typedef typename Api::World World;
    typedef typename Api::Body Body;
    typedef typename Api::Fixture Fixture;
    typedef typename Api::Joint Joint;
    typedef typename Api::Vec2 Vec2;

    explicit SceneWriter(Writer& writer) : m_out(writer) {}

    /// A map with a body's own members and its fixtures.
    void WriteBody(const Body& body) {
        m_out.BeginMap();
        const int type = Api::TypeOf(body);
        static const char* const types[] = {"static", "kinematic", "dynamic"};
        if (type != 0) Text("type", types[type]);
        Flag("bullet", body.IsBullet(), false);
        Flag("allowSleep", body.IsSleepingAllowed(), true);
        // Box2D flags static bodies as awake or not by chance.
        if (type != 0) Flag("awake", body.IsAwake(), true);
        Flag("fixedRotation", body.IsFixedRotation(), false);
        Vector("position", body.GetPosition(), 0.0f, 0.0f);
        Number("angle", body.GetAngle(), 0.0f);
        Vector("linearVelocity", body.GetLinearVelocity(), 0.0f, 0.0f);
        Number("angularVelocity", body.GetAngularVelocity(), 0.0f);
        Number("linearDamping", body.GetLinearDamping(), 0.0f);
        Number("angularDamping", body.GetAngularDamping(), 0.0f);
        Number("gravityScale", body.GetGravityScale(), 1.0f);
        const std::vector<std::vector<const Fixture*>> fixtures = FixturesOf(body);
        if (!fixtures.empty()) {
            m_out.Key("fixtures");
            m_out.BeginArray();
            for (std::size_t i = 0; i < fixtures.size(); ++i) WriteFixture(fixtures[i]);
            m_out.EndArray();
        }
        m_out.EndMap();
    }

    /// The fixtures of a body, oldest first; those that are one fixture of a scene (the edges of a chain) together.
    static std::vector<std::vector<const Fixture*>> FixturesOf(const Body& body) {
        std::vector<const Fixture*> all;
        for (const Fixture* f = body.GetFixtureList(); f != nullptr; f = f->GetNext()) all.push_back(f);
        std::vector<std::vector<const Fixture*>> groups;
        for (std::size_t i = all.size(); i-- > 0;) {
            if (groups.empty() || !Api::GoOn(*groups.back().back(), *all[i])) groups.emplace_back();
            groups.back().push_back(all[i]);
        }
        return groups;
    }

    /// A map with a joint's members; bodies and joints by their numbers.
    void WriteJoint(Joint& joint, const Numbers& bodies, const Numbers& joints) {
        m_out.BeginMap();
        Text("type", Api::NameOf(joint));
        Whole("bodyA", bodies.at(joint.GetBodyA()), -1);
        Whole("bodyB", bodies.at(joint.GetBodyB()), -1);
        Flag("collideConnected", joint.GetCollideConnected(), false);
        Api::WriteJoint(*this, joint, joints);
        m_out.EndMap();
    }

    void Always(const char* key, float value) {
        m_out.Key(key);
        m_out.Value(value);
    }
    // Members, left out where they have their default.
    void Number(const char* key, float value, float usual) {
        if (BitsOf(value) == BitsOf(usual)) return;
        m_out.Key(key);
        m_out.Value(value);
    }
    void Whole(const char* key, std::int64_t value, std::int64_t usual) {
        if (value == usual) return;
        m_out.Key(key);
        m_out.Value(value);
    }
    void Flag(const char* key, bool value, bool usual) {
        if (value == usual) return;
        m_out.Key(key);
        m_out.Value(value);
    }
    void Vector(const char* key, const Vec2& value, float x, float y) {
        if (BitsOf(value.x) == BitsOf(x) && BitsOf(value.y) == BitsOf(y)) return;
        m_out.Key(key);
        Point(value);
    }
    void Text(const char* key, const char* value) {
        m_out.Key(key);
        m_out.Value(value);
    }
    void Points(const char* key, const Vec2* points, int count) {
        m_out.Key(key);
        m_out.BeginArray();
        for (int i = 0; i < count; ++i) Point(points[i]);
        m_out.EndArray();
    }

    // Members that several types of joints have.
    template <typename Any>
    void Anchors(const Any& joint) {
        Vector("localAnchorA", joint.GetLocalAnchorA(), 0.0f, 0.0f);
        Vector("localAnchorB", joint.GetLocalAnchorB(), 0.0f, 0.0f);
    }
    template <typename Any>
    void Spring(const Any& joint) {
        Number("stiffness", joint.GetStiffness(), 0.0f);
        Number("damping", joint.GetDamping(), 0.0f);
    }
    template <typename Any>
    void Motor(const Any& joint) {
        Flag("enableMotor", joint.IsMotorEnabled(), false);
        Number("motorSpeed", joint.GetMotorSpeed(), 0.0f);
    }
    template <typename Any>
    void Limits(const Any& joint, const char* lower, const char* upper) {
        Flag("enableLimit", joint.IsLimitEnabled(), false);
        Number(lower, joint.GetLowerLimit(), 0.0f);
        Number(upper, joint.GetUpperLimit(), 0.0f);
    }

private:
    void Point(const Vec2& value) {
        m_out.BeginArray();
        m_out.Value(value.x);
        m_out.Value(value.y);
        m_out.EndArray();
    }

    void WriteFixture(const std::vector<const Fixture*>& group) {
        const Fixture& fixture = *group.front();
        m_out.BeginMap();
        m_out.Key("shape");
        m_out.BeginMap();
        Api::WriteShape(*this, group);
        m_out.EndMap();
        Number("density", fixture.GetDensity(), 0.0f);
        Number("friction", fixture.GetFriction(), 0.2f);
        Number("restitution", fixture.GetRestitution(), 0.0f);
        Flag("isSensor", fixture.IsSensor(), false);
        Number("tangentSpeed", Api::TangentSpeedOf(fixture), 0.0f);
        Whole("categoryBits", CategoryOf(fixture.GetFilterData().categoryBits), 1);
        Whole("maskBits", static_cast<std::uint16_t>(fixture.GetFilterData().maskBits), 0xFFFF);
        Whole("groupIndex", fixture.GetFilterData().groupIndex, 0);
        m_out.EndMap();
    }

    /// Scenes have 16 categories. What has only others gets the last one, or nothing would collide with it.
    template <typename Bits>
    static std::uint16_t CategoryOf(Bits bits) {
        const std::uint16_t known = static_cast<std::uint16_t>(bits);
        return known == 0 && bits != 0 ? std::uint16_t(0x8000) : known;
    }

    Writer& m_out;
};

/// Shapes that all engines of Box2D 2.4's kind have.
template <typename Api, typename Scene>
class UsualShapes {
public:
    typedef typename Api::Shape Shape;
    typedef typename Api::Vec2 Vec2;

    static void Write(Scene& scene, const Shape& shape) {
        if (shape.GetType() == Shape::e_circle) {
            const typename Api::Circle& circle = static_cast<const typename Api::Circle&>(shape);
            scene.Text("type", "circle");
            scene.Always("radius", circle.m_radius);
            scene.Vector("center", circle.m_p, 0.0f, 0.0f);
        } else if (shape.GetType() == Shape::e_edge) {
            const typename Api::Edge& edge = static_cast<const typename Api::Edge&>(shape);
            const Vec2 vertices[] = {edge.m_vertex1, edge.m_vertex2, edge.m_vertex0, edge.m_vertex3};
            scene.Text("type", "edge");
            scene.Points("vertices", vertices, edge.m_oneSided ? 4 : 2);
        } else if (shape.GetType() == Shape::e_polygon) {
            WritePolygon(scene, static_cast<const typename Api::Polygon&>(shape));
        }
    }

private:
    static void WritePolygon(Scene& scene, const typename Api::Polygon& polygon) {
        Vec2 extents, center;
        float angle = 0.0f;
        if (IsBox(polygon, extents, center, angle)) {
            scene.Text("type", "box");
            scene.Vector("center", center, 0.0f, 0.0f);
            scene.Vector("halfExtents", extents, 0.0f, 0.0f);
            scene.Number("angle", angle, 0.0f);
        } else {
            scene.Text("type", "polygon");
            scene.Points("vertices", polygon.m_vertices, polygon.m_count);
        }
    }

    static bool HaveSameVertices(const typename Api::Polygon& a, const typename Api::Polygon& b) {
        for (int i = 0; i < 4; ++i) {
            if (!(a.m_vertices[i].x == b.m_vertices[i].x && a.m_vertices[i].y == b.m_vertices[i].y)) return false;
        }
        return true;
    }

    /// Whether SetAsBox makes this polygon, to the bit, and of what. A polygon that does not come from there goes
    /// through Set, which may begin with another vertex and so lead to other sums.
    static bool IsBox(const typename Api::Polygon& polygon, Vec2& extents, Vec2& center, float& angle) {
        if (polygon.m_count != 4) return false;
        const Vec2* v = polygon.m_vertices;
        typename Api::Polygon box;
        extents = v[2];
        center.Set(0.0f, 0.0f);
        if (extents.x > 0.0f && extents.y > 0.0f) {
            box.SetAsBox(extents.x, extents.y);
            if (HaveSameVertices(polygon, box)) return true;
        }
        center = polygon.m_centroid;
        const float turned = std::atan2(polygon.m_normals[1].y, polygon.m_normals[1].x);
        const float width = 0.5f * std::sqrt(Square(v[1].x - v[0].x) + Square(v[1].y - v[0].y));
        const float height = 0.5f * std::sqrt(Square(v[3].x - v[0].x) + Square(v[3].y - v[0].y));
        if (!(width > 0.0f && height > 0.0f)) return false;
        // Rounding may have moved each of them by some last digits.
        for (int a = 0; a < 5; ++a) {
            for (int w = 0; w < 9; ++w) {
                for (int h = 0; h < 9; ++h) {
                    angle = Near(turned, a);
                    extents.Set(Near(width, w), Near(height, h));
                    box.SetAsBox(extents.x, extents.y, center, angle);
                    if (HaveSameVertices(polygon, box)) return true;
                }
            }
        }
        return false;
    }
    static float Square(float value) { return value * value; }
    /// The value, its neighbours, theirs …
    static float Near(float value, int which) {
        const std::uint32_t bits = BitsOf(value);
        if ((bits & 0x7FFFFFFFu) == 0) return value;
        const std::uint32_t steps = static_cast<std::uint32_t>((which + 1) / 2);
        return FloatOf(which % 2 != 0 ? bits + steps : bits - steps);
    }
};

// The members of joints that are named alike in every engine of Box2D's kind.

template <typename Scene, typename Any>
void WriteRevolute(Scene& scene, const Any& joint) {
    scene.Anchors(joint);
    scene.Number("referenceAngle", joint.GetReferenceAngle(), 0.0f);
    scene.Limits(joint, "lowerAngle", "upperAngle");
    scene.Motor(joint);
    scene.Number("maxMotorTorque", joint.GetMaxMotorTorque(), 0.0f);
}

template <typename Scene, typename Any>
void WritePrismatic(Scene& scene, const Any& joint) {
    scene.Anchors(joint);
    scene.Vector("localAxisA", joint.GetLocalAxisA(), 1.0f, 0.0f);
    scene.Number("referenceAngle", joint.GetReferenceAngle(), 0.0f);
    scene.Limits(joint, "lowerTranslation", "upperTranslation");
    scene.Motor(joint);
    scene.Number("maxMotorForce", joint.GetMaxMotorForce(), 0.0f);
}

template <typename Scene, typename Any>
void WriteWheel(Scene& scene, const Any& joint) {
    scene.Anchors(joint);
    scene.Vector("localAxisA", joint.GetLocalAxisA(), 1.0f, 0.0f);
    scene.Limits(joint, "lowerTranslation", "upperTranslation");
    scene.Motor(joint);
    scene.Number("maxMotorTorque", joint.GetMaxMotorTorque(), 0.0f);
    scene.Spring(joint);
}

template <typename Scene, typename Any>
void WriteWeld(Scene& scene, const Any& joint) {
    scene.Anchors(joint);
    scene.Number("referenceAngle", joint.GetReferenceAngle(), 0.0f);
    scene.Spring(joint);
}

template <typename Scene, typename Any>
void WriteFriction(Scene& scene, const Any& joint) {
    scene.Anchors(joint);
    scene.Number("maxForce", joint.GetMaxForce(), 0.0f);
    scene.Number("maxTorque", joint.GetMaxTorque(), 0.0f);
}

template <typename Scene, typename Any>
void WriteMotorJoint(Scene& scene, const Any& joint) {
    scene.Vector("linearOffset", joint.GetLinearOffset(), 0.0f, 0.0f);
    scene.Number("angularOffset", joint.GetAngularOffset(), 0.0f);
    scene.Number("maxForce", joint.GetMaxForce(), 0.0f);
    scene.Number("maxTorque", joint.GetMaxTorque(), 0.0f);
    scene.Number("correctionFactor", joint.GetCorrectionFactor(), 0.3f);
}

template <typename Scene, typename Any>
void WritePulley(Scene& scene, Any& joint) {
    scene.Vector("localAnchorA", joint.GetBodyA()->GetLocalPoint(joint.GetAnchorA()), 0.0f, 0.0f);
    scene.Vector("localAnchorB", joint.GetBodyB()->GetLocalPoint(joint.GetAnchorB()), 0.0f, 0.0f);
    scene.Vector("groundAnchorA", joint.GetGroundAnchorA(), 0.0f, 0.0f);
    scene.Vector("groundAnchorB", joint.GetGroundAnchorB(), 0.0f, 0.0f);
    scene.Number("lengthA", joint.GetLengthA(), 0.0f);
    scene.Number("lengthB", joint.GetLengthB(), 0.0f);
    scene.Number("ratio", joint.GetRatio(), 1.0f);
}

template <typename Scene, typename Any>
void WriteMouse(Scene& scene, Any& joint) {
    scene.Vector("localAnchorB", joint.GetBodyB()->GetLocalPoint(joint.GetAnchorB()), 0.0f, 0.0f);
    scene.Vector("target", joint.GetTarget(), 0.0f, 0.0f);
    scene.Number("maxForce", joint.GetMaxForce(), 0.0f);
    scene.Spring(joint);
}

template <typename Scene, typename Any>
void WriteGear(Scene& scene, Any& joint, const Numbers& joints) {
    scene.Whole("joint1", joints.at(joint.GetJoint1()), 0);
    scene.Whole("joint2", joints.at(joint.GetJoint2()), 0);
    scene.Number("ratio", joint.GetRatio(), 1.0f);
}

template <typename Scene>
void WriteLengths(Scene& scene, float length, float least, float most) {
    scene.Number("length", length, 1.0f);
    scene.Number("minLength", least, 0.0f);
    scene.Number("maxLength", most, FLT_MAX);
}

/// The value of a member whose size the rest does not depend on, so that it can be set later; in JSON it is left out.
inline std::size_t BeginLater(CborWriter& out, float value) {
    out.Key("timeStep");
    out.Value(value);
    return out.GetBytes().size() - 4;
}
inline std::size_t BeginLater(JsonWriter&, float) { return 0; }

/// A world as the map that a scene file holds. Bodies and joints are listed oldest first, movers and others alike, and
/// get their numbers in this order. Returns where in CBOR the bits of the time step stand.
template <typename Api, typename Writer>
std::size_t WriteWorld(Writer& out, typename Api::World& world, const Options& options, Numbers& bodyNumbers,
                       Numbers& jointNumbers) {
    typedef typename Api::Body Body;
    typedef typename Api::Joint Joint;
    SceneWriter<Api, Writer> scene(out);
    out.BeginMap();
    scene.Text("format", "scree-scene");
    scene.Whole("version", 1, 0);
    scene.Vector("gravity", world.GetGravity(), 0.0f, -10.0f);
    const std::size_t timeStepAt = BeginLater(out, 1.0f / 60.0f);
    scene.Whole("velocityIterations", options.velocityIterations, 8);
    scene.Whole("positionIterations", options.positionIterations, 3);
    std::vector<Body*> bodies;
    for (Body* b = world.GetBodyList(); b != nullptr; b = b->GetNext()) bodies.push_back(b);
    Api::SortByAge(bodies);
    for (std::size_t i = 0; i < bodies.size(); ++i) bodyNumbers[bodies[i]] = static_cast<std::int64_t>(i);
    if (!bodies.empty()) {
        out.Key("bodies");
        out.BeginArray();
        for (std::size_t i = 0; i < bodies.size(); ++i) scene.WriteBody(*bodies[i]);
        out.EndArray();
    }
    std::vector<Joint*> joints;
    for (Joint* j = world.GetJointList(); j != nullptr; j = j->GetNext()) joints.push_back(j);
    std::reverse(joints.begin(), joints.end());
    for (std::size_t i = 0; i < joints.size(); ++i) jointNumbers[joints[i]] = static_cast<std::int64_t>(i);
    if (!joints.empty()) {
        out.Key("joints");
        out.BeginArray();
        for (std::size_t i = 0; i < joints.size(); ++i) scene.WriteJoint(*joints[i], bodyNumbers, jointNumbers);
        out.EndArray();
    }
    out.Key("user");
    out.BeginMap();
    out.Key("writer");
    out.Value(std::string(Api::Writer()) + ", " + Api::Engine());
    bool hasBodies = false;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const std::uint64_t data = ToNumber(bodies[i]->GetUserData());
        if (data == 0 || data > mostUserData) continue;
        if (!hasBodies) {
            out.Key("bodies");
            out.BeginMap();
            hasBodies = true;
        }
        out.Key(std::to_string(i).c_str());
        out.BeginMap();
        out.Key("userData");
        out.Value(static_cast<std::int64_t>(data));
        out.EndMap();
    }
    if (hasBodies) out.EndMap();
    out.EndMap();
    out.EndMap();
    return timeStepAt;
}

/// Makes a file of a text; false if it cannot be written.
inline bool WriteText(const std::string& path, const std::string& text) {
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (file == nullptr) return false;
    const bool isWhole = std::fwrite(text.data(), 1, text.size(), file) == text.size();
    return std::fclose(file) == 0 && isWhole;
}

}  // namespace detail
}  // namespace scree_capture
