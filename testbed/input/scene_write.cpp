// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A scene as text: one body and one joint a line, so that files can be compared by lines.

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <iterator>
#include <string>
#include <type_traits>

#include "scenes/support.h"
#include "testbed/base/errors.h"
#include "testbed/input/json_tree.h"
#include "testbed/input/scene_fields.h"
#include "testbed/input/scene_file.h"

namespace testbed {

namespace {

bool HaveSameBits(float a, float b) { return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b); }
bool HaveSameBits(scenes::Vec2 a, scenes::Vec2 b) { return HaveSameBits(a.x, b.x) && HaveSameBits(a.y, b.y); }
template <typename T>
bool HaveSameBits(const T& a, const T& b) {
    return a == b;
}

class Writer {
public:
    explicit Writer(const scenes::Scene& scene) : m_scene(scene) {}

    std::string Write() {
        Append("{{\n\"format\": \"{}\",\n\"version\": {}", sceneFormat, sceneVersion);
        ForEachField<scenes::Scene>([&](const auto& field) {
            Append(",\n\"{}\": ", field.name);
            Value(m_scene.*field.member);
        });
        WriteList("bodies", m_scene.bodies, [this](const scenes::Body& body) { WriteBody(body); });
        WriteList("joints", m_scene.joints, [this](const scenes::Joint& joint) { WriteJoint(joint); });
        WriteList("spawns", m_scene.spawns, [this](const scenes::Spawn& spawn) {
            ForEachField<scenes::Spawn>([&](const auto& field) { Member(field.name, spawn.*field.member); });
        });
        if (!m_scene.user.empty()) Append(",\n\"user\": {}", m_scene.user);
        m_text += "\n}\n";
        return std::move(m_text);
    }

private:
    template <typename... Arguments>
    void Append(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(m_text), format, std::forward<Arguments>(arguments)...);
    }

    // "-0" would be read as the whole number 0.
    void Value(float value) { HaveSameBits(value, -0.0f) ? Append("-0.0") : Append("{}", value); }
    void Value(scenes::Vec2 value) {
        m_text += '[';
        Value(value.x);
        m_text += ", ";
        Value(value.y);
        m_text += ']';
    }
    void Value(bool value) { m_text += value ? "true" : "false"; }
    void Value(const std::string& value) { m_text += QuoteJson(value); }
    void Value(scenes::BodyType type) { Append("\"{}\"", bodyTypeNames[static_cast<std::size_t>(type)]); }
    void Value(scenes::ShapeType type) { Append("\"{}\"", shapeTypeNames[static_cast<std::size_t>(type)]); }
    void Value(scenes::JointType type) { Append("\"{}\"", jointTypeNames[static_cast<std::size_t>(type)]); }
    template <typename Whole>
    requires std::is_integral_v<Whole>
    void Value(Whole value) { Append("{}", value); }

    void Key(std::string_view name) {
        if (m_text.back() != '{') m_text += ", ";
        Append("\"{}\": ", name);
    }
    template <typename T>
    void Member(std::string_view name, const T& value) {
        Key(name);
        Value(value);
    }
    void Points(std::string_view name, std::span<const scenes::Vec2> points) {
        Key(name);
        m_text += '[';
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (i > 0) m_text += ", ";
            Value(points[i]);
        }
        m_text += ']';
    }

    /// The members that have not their default, of those that `isRead` takes.
    template <typename Owner, typename IsRead>
    void Members(const Owner& owner, IsRead&& isRead) {
        [[maybe_unused]] static const Owner defaults{};  // unused where a structure has no field
        ForEachField<Owner>([&](const auto& field) {
            if (isRead(field.name) && !HaveSameBits(owner.*field.member, defaults.*field.member)) {
                Member(field.name, owner.*field.member);
            }
        });
    }

    template <typename List, typename WriteItem>
    void WriteList(std::string_view name, const List& list, WriteItem&& writeItem) {
        if (list.empty()) return;
        Append(",\n\"{}\": [", name);
        bool isFirst = true;
        for (const auto& item : list) {
            m_text += isFirst ? "\n  {" : ",\n  {";
            isFirst = false;
            writeItem(item);
            m_text += '}';
        }
        m_text += "\n]";
    }

    void WriteBody(const scenes::Body& body) {
        Members(body, [](std::string_view) { return true; });
        if (body.fixtureCount == 0) return;
        Key("fixtures");
        m_text += '[';
        for (int i = 0; i < body.fixtureCount; ++i) {
            const scenes::Fixture& fixture = m_scene.fixtures[static_cast<std::size_t>(body.firstFixture + i)];
            m_text += i > 0 ? ", {" : "{";
            Key("shape");
            WriteShape(fixture.shape);
            Members(fixture, [](std::string_view) { return true; });
            m_text += '}';
        }
        m_text += ']';
    }

    void WriteShape(const scenes::Shape& shape) {
        const std::span<const std::string_view> keys = KeysOf(shape.type);
        const auto isRead = [keys](std::string_view name) {
            return name != "type" && std::find(keys.begin(), keys.end(), name) != keys.end();
        };
        m_text += '{';
        Member("type", shape.type);
        Members(shape, isRead);
        if (isRead("vertices") && shape.vertexCount > 0) Points("vertices", shape.Vertices());
        if (isRead("chainVertices")) Points("chainVertices", m_scene.ChainVerticesOf(shape));
        if (isRead("support")) Member("support", NameOfSupport(shape));
        m_text += '}';
    }

    static std::string NameOfSupport(const scenes::Shape& shape) {
        for (const scenes::NamedSupport& known : scenes::SupportFunctions()) {
            if (known.function == shape.support) return std::string(known.name);
        }
        throw FileError(
            "a shape has a support function without a name, which no file can hold; "
            "give it a name in scenes/support.cpp");
    }

    void WriteJoint(const scenes::Joint& joint) {
        const std::span<const std::string_view> keys = KeysOf(joint.type);
        Member("type", joint.type);
        Member("bodyA", joint.bodyA);
        Member("bodyB", joint.bodyB);
        Members(joint, [keys](std::string_view name) {
            return name != "bodyA" && name != "bodyB" && std::find(keys.begin(), keys.end(), name) != keys.end();
        });
    }

    const scenes::Scene& m_scene;
    std::string m_text;
};

}  // namespace

std::string WriteScene(const scenes::Scene& scene) { return Writer(scene).Write(); }

}  // namespace testbed
