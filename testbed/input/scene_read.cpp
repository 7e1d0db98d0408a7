// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A scene from text: each value is checked where it stands, then the scene as a whole.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "scenes/support.h"
#include "testbed/base/errors.h"
#include "testbed/base/input.h"
#include "testbed/base/nearest.h"
#include "testbed/input/json_tree.h"
#include "testbed/input/scene_fields.h"
#include "testbed/input/scene_file.h"

namespace testbed {

namespace {

using Kind = JsonNode::Kind;
using Place = JsonPlace;
using Names = std::vector<std::string_view>;

/// A body of this number of fixtures is no mistake that one would make by hand, and stays far from the end of int.
constexpr std::size_t mostItems = 20'000'000;

class Reader {
public:
    explicit Reader(std::string_view source) : m_source(source) {}

    scenes::Scene Read(const JsonNode& root) {
        const Place top{};
        Expect(root, top, Kind::object);
        CheckHeader(root, top);
        m_scene.name = NameOfScene(m_source);
        m_scene.size = 1;
        m_scene.steps = 600;
        const Names arrays{"format", "version", "bodies", "joints", "spawns", "user"};
        ReadMembers(root, top, m_scene, arrays, [](std::string_view) { return true; });
        if (root.Find("showStep") == nullptr) m_scene.showStep = m_scene.steps;
        ReadList(root, top, "bodies", [&](const JsonNode& node, const Place& at) { ReadBody(node, at); });
        ReadList(root, top, "joints", [&](const JsonNode& node, const Place& at) { ReadJoint(node, at); });
        ReadList(root, top, "spawns", [&](const JsonNode& node, const Place& at) {
            scenes::Spawn& spawn = m_scene.spawns.emplace_back();
            ReadMembers(node, at, spawn, {}, [](std::string_view) { return true; });
        });
        return std::move(m_scene);
    }

    [[noreturn]] void Fail(const std::string& what) const { throw FileError(fmt::format("{}: {}", m_source, what)); }

private:
    [[noreturn]] void Fail(const Place& place, const std::string& what) const {
        const std::string at = place.Describe();
        Fail(at.empty() ? what : fmt::format("{}: {}", at, what));
    }

    void Expect(const JsonNode& node, const Place& place, Kind kind) const {
        if (node.kind != kind) Fail(place, fmt::format("give {}, not {}", NameOf(kind), NameOf(node.kind)));
    }

    void CheckHeader(const JsonNode& root, const Place& top) const {
        const JsonNode* format = root.Find("format");
        const JsonNode* version = root.Find("version");
        if (format == nullptr || format->kind != Kind::string || format->Text() != sceneFormat) {
            Fail(fmt::format("no scene file: it has to hold \"format\": \"{}\"", sceneFormat));
        }
        if (version == nullptr || version->kind != Kind::number || !version->isWhole || version->number < 1) {
            Fail(Place{&top, "version"}, fmt::format("give a version, for example {}", sceneVersion));
        }
        if (version->number > sceneVersion) {
            Fail(Place{&top, "version"}, fmt::format("version {:.0f} is newer than this program, which reads up to {}",
                                                     version->number, sceneVersion));
        }
    }

    // Values.
    void Value(const JsonNode& node, const Place& place, float& value) const {
        Expect(node, place, Kind::number);
        value = static_cast<float>(node.number);
        if (!std::isfinite(value)) Fail(place, "the number is too large for a float (3.4e38)");
    }
    void Value(const JsonNode& node, const Place& place, scenes::Vec2& value) const {
        if (node.kind != Kind::array || node.items.size() != 2) Fail(place, "give two numbers, [x, y]");
        Value(node.items[0], Place{&place, {}, 0}, value.x);
        Value(node.items[1], Place{&place, {}, 1}, value.y);
    }
    void Value(const JsonNode& node, const Place& place, bool& value) const {
        Expect(node, place, Kind::boolean);
        value = node.number != 0.0;
    }
    void Value(const JsonNode& node, const Place& place, std::string& value) const {
        Expect(node, place, Kind::string);
        value = node.Text();
    }
    template <typename Whole>
    requires std::is_integral_v<Whole>
    void Value(const JsonNode& node, const Place& place, Whole& value) const {
        Expect(node, place, Kind::number);
        constexpr auto low = std::numeric_limits<Whole>::min(), high = std::numeric_limits<Whole>::max();
        if (!node.isWhole || node.number < low || node.number > high) {
            Fail(place, fmt::format("give a whole number from {} to {}", low, high));
        }
        value = static_cast<Whole>(node.number);
    }
    template <typename Enum>
    requires std::is_enum_v<Enum>
    void Value(const JsonNode& node, const Place& place, Enum& value) const {
        Expect(node, place, Kind::string);
        const std::span<const std::string_view> names = NamesOf(value);
        const auto found = std::find(names.begin(), names.end(), node.Text());
        if (found == names.end()) Fail(place, DescribeUnknown("type", node.Text(), names));
        value = static_cast<Enum>(found - names.begin());
    }
    static std::span<const std::string_view> NamesOf(scenes::BodyType) { return bodyTypeNames; }
    static std::span<const std::string_view> NamesOf(scenes::ShapeType) { return shapeTypeNames; }
    static std::span<const std::string_view> NamesOf(scenes::JointType) { return jointTypeNames; }

    // Objects.
    /// Reads the members of Owner's list that `isRead` takes; `others` are keys that the caller reads.
    template <typename Owner, typename IsRead>
    void ReadMembers(const JsonNode& node, const Place& place, Owner& owner, const Names& others, IsRead&& isRead) {
        Expect(node, place, Kind::object);
        for (std::size_t i = 0; i < node.keys.size(); ++i) {
            const std::string_view key = node.keys[i];
            const Place at{&place, key};
            bool isKnown = std::find(others.begin(), others.end(), key) != others.end();
            ForEachField<Owner>([&](const auto& field) {
                if (isKnown || field.name != key || !isRead(key)) return;
                isKnown = true;
                Value(node.items[i], at, owner.*field.member);
            });
            if (!isKnown) FailOfKey<Owner>(place, key, others, isRead);
        }
    }

    template <typename Owner, typename IsRead>
    [[noreturn]] void FailOfKey(const Place& place, std::string_view key, const Names& others, IsRead&& isRead) const {
        Names known = others;
        ForEachField<Owner>([&](const auto& field) {
            if (isRead(field.name)) known.push_back(field.name);
        });
        Fail(place, DescribeUnknown("key", key, known));
    }

    template <typename ReadItem>
    void ReadList(const JsonNode& node, const Place& place, std::string_view key, ReadItem&& readItem) {
        const JsonNode* list = node.Find(key);
        if (list == nullptr) return;
        const Place at{&place, key};
        Expect(*list, at, Kind::array);
        if (list->items.size() > mostItems) Fail(at, fmt::format("more than {} items", mostItems));
        for (std::size_t i = 0; i < list->items.size(); ++i) {
            readItem(list->items[i], Place{&at, {}, static_cast<int>(i)});
        }
    }

    void ReadBody(const JsonNode& node, const Place& place) {
        static const Names others{"fixtures"};
        scenes::Body& body = m_scene.bodies.emplace_back();
        ReadMembers(node, place, body, others, [](std::string_view) { return true; });
        body.firstFixture = static_cast<int>(m_scene.fixtures.size());
        ReadList(node, place, "fixtures", [&](const JsonNode& item, const Place& at) {
            static const Names fixtureOthers{"shape"};
            scenes::Fixture& fixture = m_scene.fixtures.emplace_back();
            ReadMembers(item, at, fixture, fixtureOthers, [](std::string_view) { return true; });
            const JsonNode* shape = item.Find("shape");
            if (shape == nullptr) Fail(at, "a fixture needs a \"shape\"");
            ReadShape(*shape, Place{&at, "shape"}, fixture.shape);
        });
        body.fixtureCount = static_cast<int>(m_scene.fixtures.size()) - body.firstFixture;
    }

    /// The type of a shape or a joint, which decides about its other keys.
    template <typename Type>
    void ReadType(const JsonNode& node, const Place& place, Type& type) const {
        Expect(node, place, Kind::object);
        const JsonNode* name = node.Find("type");
        if (name == nullptr) Fail(place, fmt::format("give its \"type\": {}", fmt::join(NamesOf(type), ", ")));
        Value(*name, Place{&place, "type"}, type);
    }

    void ReadShape(const JsonNode& node, const Place& place, scenes::Shape& shape) {
        ReadType(node, place, shape.type);
        const std::span<const std::string_view> keys = KeysOf(shape.type);
        Names others;
        for (const std::string_view key : {"vertices", "chainVertices", "support"}) {
            if (std::find(keys.begin(), keys.end(), key) != keys.end()) others.push_back(key);
        }
        ReadMembers(node, place, shape, others, [keys](std::string_view name) {
            return name == "type" || std::find(keys.begin(), keys.end(), name) != keys.end();
        });
        for (const std::string_view key : others) {
            const JsonNode* item = node.Find(key);
            const Place at{&place, key};
            if (key == "support") {
                if (item == nullptr) Fail(place, "give the name of its \"support\" function");
                ReadSupport(*item, at, shape);
            } else if (key == "vertices") {
                if (item != nullptr) ReadVertices(*item, at, shape);
            } else {
                if (item == nullptr) Fail(place, "give its \"chainVertices\"");
                ReadChainVertices(*item, at, shape);
            }
        }
    }

    void ReadSupport(const JsonNode& node, const Place& place, scenes::Shape& shape) const {
        Expect(node, place, Kind::string);
        Names names;
        for (const scenes::NamedSupport& known : scenes::SupportFunctions()) {
            if (known.name == node.Text()) shape.support = known.function;
            names.push_back(known.name);
        }
        if (shape.support == nullptr) Fail(place, DescribeUnknown("support function", node.Text(), names));
    }

    void ReadVertices(const JsonNode& node, const Place& place, scenes::Shape& shape) const {
        Expect(node, place, Kind::array);
        if (node.items.size() > shape.vertices.size()) {
            Fail(place, fmt::format("{} vertices, at most {} fit; a largePolygon takes 64 as chainVertices",
                                    node.items.size(), shape.vertices.size()));
        }
        for (std::size_t i = 0; i < node.items.size(); ++i) {
            Value(node.items[i], Place{&place, {}, static_cast<int>(i)}, shape.vertices[i]);
        }
        shape.vertexCount = static_cast<std::uint8_t>(node.items.size());
    }

    void ReadChainVertices(const JsonNode& node, const Place& place, scenes::Shape& shape) {
        Expect(node, place, Kind::array);
        if (node.items.size() > mostItems) Fail(place, fmt::format("more than {} vertices", mostItems));
        shape.firstChainVertex = static_cast<int>(m_scene.chainVertices.size());
        shape.chainVertexCount = static_cast<int>(node.items.size());
        for (std::size_t i = 0; i < node.items.size(); ++i) {
            Value(node.items[i], Place{&place, {}, static_cast<int>(i)}, m_scene.chainVertices.emplace_back());
        }
    }

    void ReadJoint(const JsonNode& node, const Place& place) {
        scenes::Joint& joint = m_scene.joints.emplace_back();
        ReadType(node, place, joint.type);
        const std::span<const std::string_view> keys = KeysOf(joint.type);
        for (const std::string_view key : {"bodyA", "bodyB"}) {
            if (node.Find(key) == nullptr) Fail(place, fmt::format("give its \"{}\", an index into bodies", key));
        }
        ReadMembers(node, place, joint, {}, [keys](std::string_view name) {
            return name == "type" || std::find(keys.begin(), keys.end(), name) != keys.end();
        });
    }

    std::string_view m_source;
    scenes::Scene m_scene;
};

/// What stands below "user", as text; the parser that keeps any JSON.
std::string UserText(std::string_view text, const JsonNode& root, const Reader& reader) {
    const JsonNode* user = root.Find("user");
    if (user == nullptr) return {};
    if (user->kind != Kind::object) reader.Fail("user: give an object");
    return nlohmann::ordered_json::parse(text).at("user").dump();
}

}  // namespace

std::string NameOfScene(std::string_view source) {
    std::string name(source.substr(source.find_last_of('/') + 1));
    name = name.substr(0, name.find('.'));
    for (char& c : name) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_') c = '-';
    }
    if (name.size() > 64) name.resize(64);
    return name.empty() ? "scene" : name;
}

scenes::Scene ReadScene(const JsonNode& root, std::string_view source) {
    Reader reader(source);
    scenes::Scene scene = reader.Read(root);
    if (const std::string fault = DescribeFault(scene); !fault.empty()) reader.Fail(fault);
    return scene;
}

scenes::Scene ReadScene(std::string_view text, std::string_view source) {
    const JsonNode root = ParseJson(text, source);
    Reader reader(source);
    scenes::Scene scene = reader.Read(root);
    scene.user = UserText(text, root, reader);
    if (const std::string fault = DescribeFault(scene); !fault.empty()) reader.Fail(fault);
    return scene;
}

scenes::Scene ReadSceneFile(const std::filesystem::path& file) {
    return ReadScene(ReadText(file, "give a *.scene.json file"), file.string());
}

}  // namespace testbed
