// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A track's records from the first to the last that is whole: where its steps are, and which objects came and went.

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "testbed/base/errors.h"
#include "testbed/base/input.h"
#include "testbed/capture/scree_capture_format.h"
#include "testbed/input/scene_file.h"
#include "testbed/input/track_data.h"

namespace testbed {

namespace {

constexpr std::string_view magic{"\x89TRACK\r\n", 8};
constexpr int trackVersion = 1;
/// What a block may become: writers do not deflate what gets smaller than this share, so that memory stays in
/// proportion to the file.
constexpr std::size_t mostInflation = 256;
constexpr std::int64_t mostNumber = std::int64_t{1} << 53;
constexpr int mostSteps = 2'000'000'000;

ByteSpan AsBytes(std::string_view text) { return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}; }

nlohmann::ordered_json ToJson(const JsonNode& node) {
    switch (node.kind) {
        case JsonNode::Kind::null:
            break;
        case JsonNode::Kind::boolean:
            return node.number != 0.0;
        case JsonNode::Kind::number:
            if (node.isWhole && std::abs(node.number) <= static_cast<double>(mostNumber)) {
                return static_cast<std::int64_t>(node.number);
            }
            return node.number;
        case JsonNode::Kind::string:
            return node.Text();
        case JsonNode::Kind::array: {
            auto array = nlohmann::ordered_json::array();
            for (const JsonNode& item : node.items) array.push_back(ToJson(item));
            return array;
        }
        case JsonNode::Kind::object: {
            // Added at the end as they are: no key stands twice, and emplace would look for each among all before it.
            nlohmann::ordered_json::object_t object;
            for (std::size_t i = 0; i < node.keys.size(); ++i) {
                object.emplace_back(node.keys[i], ToJson(node.items[i]));
            }
            return object;
        }
    }
    return nullptr;
}

/// The item of a key of an object, made if there is none.
JsonNode& ItemOf(JsonNode& object, std::string_view key) {
    const auto found = std::find(object.keys.begin(), object.keys.end(), key);
    if (found != object.keys.end()) return object.items[static_cast<std::size_t>(found - object.keys.begin())];
    object.keys.emplace_back(key);
    JsonNode& item = object.items.emplace_back();
    item.kind = JsonNode::Kind::array;
    return item;
}

/// The index of an object by its number, or −1. Numbers grow with indices.
template <typename Object>
int IndexOf(const std::vector<Object>& objects, double number) {
    const auto found = std::lower_bound(objects.begin(), objects.end(), number, [](const Object& object, double value) {
        return static_cast<double>(object.number) < value;
    });
    if (found == objects.end() || static_cast<double>(found->number) != number) return -1;
    return static_cast<int>(found - objects.begin());
}

class Indexer {
public:
    explicit Indexer(TrackFile::Data& data) : m_data(data) {}

    void Run() {
        const std::string_view all = m_data.bytes;
        if (!IsTrack(all)) {
            throw FileError(
                fmt::format("{}: not a track: it does not begin with the 8 bytes of every track; give a file that a "
                            "scree_capture header has recorded",
                            m_data.source));
        }
        std::size_t at = magic.size();
        while (at < all.size() && m_data.info.damage.empty()) at = ReadRecord(at);
        if (!m_hasHeader) {
            const std::string& why = m_data.info.damage;
            throw FileError(fmt::format("{}: {}; record it again", m_data.source,
                                        why.empty() ? "it ends before its first record" : why));
        }
        if (!m_data.info.damage.empty()) {
            m_data.info.damage +=
                m_data.steps.empty() ? ": no step read" : fmt::format(": read up to step {}", m_data.steps.back());
        }
        for (const int body : m_waiting) m_data.bodies[static_cast<std::size_t>(body)].createdAfter = GetNextStep();
        for (const int joint : m_waitingJoints) {
            m_data.joints[static_cast<std::size_t>(joint)].createdAfter = GetNextStep();
        }
        FinishParts();
    }

private:
    [[nodiscard]] int GetNextStep() const { return m_data.steps.empty() ? 1 : m_data.steps.back() + 1; }

    /// Returns where the next one begins.
    std::size_t ReadRecord(std::size_t at) {
        const std::string_view all = m_data.bytes;
        ++m_number;
        const auto readWord = [&](std::size_t position) {
            std::uint32_t word = 0;
            for (std::size_t i = 0; i < 4; ++i) {
                word |= static_cast<std::uint32_t>(static_cast<unsigned char>(all[position + i])) << (8 * i);
            }
            return word;
        };
        if (all.size() - at < 8 || readWord(at) > all.size() - at - 8) {
            m_data.info.damage = fmt::format("ends within record {}, which begins at byte {}", m_number, at);
            return at;
        }
        const std::size_t size = readWord(at);
        const ByteSpan payload = AsBytes(all).subspan(at + 8, size);
        if (scree_capture::detail::Crc32::Of(payload.data(), size) != readWord(at + 4)) {
            m_data.info.damage = fmt::format("record {} at byte {} has not the bytes of its checksum", m_number, at);
            return at;
        }
        m_context = fmt::format("{}: record {}", m_data.source, m_number);
        ReadPayload(payload, at + 8);
        return at + 8 + size;
    }

    void ReadPayload(ByteSpan payload, std::size_t at) {
        CborReader reader(payload, m_context, at);
        if (reader.NextMap("a record") != 1) reader.Fail("give a record as a map with one key");
        const std::string_view kind = reader.NextText("the kind of a record");
        if (!m_hasHeader && kind != "header") reader.Fail("the first record has to be the header");
        if (kind == "header") {
            if (m_hasHeader) reader.Fail("a second header; join no two tracks");
            ReadHeader(reader);
            m_hasHeader = true;
        } else if (kind == "steps") {
            m_data.blocks.push_back({at, payload.size(), 0, m_number});
            ReadSteps(reader);
        } else if (kind == "deflated") {
            TrackBlock block{at, payload.size(), 0, m_number};
            if (reader.NextArray("deflated") != 2) reader.Fail("deflated: give [length, bytes]");
            const std::int64_t length = reader.NextWhole("the length inflated", 1, std::int64_t{1} << 31);
            const ByteSpan bytes = reader.NextBytes("the deflated bytes");
            if (static_cast<std::size_t>(length) > mostInflation * (bytes.size() + 64)) {
                reader.Fail(fmt::format("deflated to less than 1/{}; write such a block as it is", mostInflation));
            }
            block.inflatedSize = static_cast<std::size_t>(length);
            m_data.blocks.push_back(block);
            CborReader inner = m_data.Open(static_cast<int>(m_data.blocks.size()) - 1);
            if (inner.NextMap("a block") != 1 || inner.NextText("the kind of a block") != "steps") {
                inner.Fail("only steps are deflated");
            }
            ReadSteps(inner);
            if (!inner.IsAtEnd()) inner.Fail("more bytes than the block's item; leave them out");
        } else if (kind == "objects") {
            ReadObjects(reader);
        } else {
            reader.Skip();  // of a later writer
        }
        if (!reader.IsAtEnd()) reader.Fail("more bytes than the record's item; leave them out");
    }

    void ReadHeader(CborReader& reader) {
        bool hasFormat = false, hasScene = false;
        for (std::uint64_t left = reader.NextMap("header"); left > 0; --left) {
            const std::string_view key = reader.NextText("a key");
            if (key == "format") {
                hasFormat = reader.NextText("format") == "scree-track";
            } else if (key == "version") {
                m_data.info.version = static_cast<int>(reader.NextWhole("version", 1, 1'000'000));
                if (m_data.info.version > trackVersion) {
                    reader.Fail(fmt::format("version {} is newer than this program, which reads up to {}",
                                            m_data.info.version, trackVersion));
                }
            } else if (key == "writer") {
                m_data.info.writer = reader.NextText("writer");
            } else if (key == "engine") {
                m_data.info.engine = reader.NextText("engine");
            } else if (key == "timeStep") {
                m_data.info.timeStep = reader.NextFloat("timeStep");
            } else if (key == "scene") {
                if (hasScene) reader.Fail("a second scene");
                m_root = reader.NextTree();
                hasScene = true;
            } else {
                reader.Skip();
            }
        }
        if (!hasFormat) reader.Fail("header: give \"format\": \"scree-track\"");
        if (!hasScene) reader.Fail("header: give the scene");
        StartParts(reader);
    }

    /// The bodies and joints of the header's scene.
    void StartParts(CborReader& reader) {
        if (m_root.kind != JsonNode::Kind::object) reader.Fail("scene: give a map");
        if (m_root.Find("spawns") != nullptr) reader.Fail("scene: spawns; a track creates its bodies in steps");
        const JsonNode& bodies = ItemOf(m_root, "bodies");
        m_data.bodies.resize(bodies.items.size());
        for (std::size_t i = 0; i < m_data.bodies.size(); ++i) m_data.bodies[i].number = static_cast<std::int64_t>(i);
        const JsonNode& joints = ItemOf(m_root, "joints");
        m_data.joints.resize(joints.items.size());
        for (std::size_t i = 0; i < m_data.joints.size(); ++i) m_data.joints[i].number = static_cast<std::int64_t>(i);
        m_data.user = nlohmann::ordered_json::object();
        const JsonNode* user = m_root.Find("user");
        if (user == nullptr) return;
        if (user->kind != JsonNode::Kind::object) reader.Fail("user: give a map");
        m_data.user = ToJson(*user);
        if (!m_data.user.contains("bodies")) return;
        const nlohmann::ordered_json told = m_data.user["bodies"];
        m_data.user.erase("bodies");
        if (!told.is_object()) return;
        for (const auto& [key, value] : told.items()) {
            const bool isNumber = !key.empty() && key.size() < 10 && key.find_first_not_of("0123456789") == key.npos;
            const std::size_t index = isNumber ? std::stoul(key) : m_data.bodies.size();
            if (index >= m_data.bodies.size() || !value.is_object()) continue;
            m_data.bodyUsers[static_cast<int>(index)] = value;
            if (value.contains("name") && value["name"].is_string()) m_data.bodies[index].name = value["name"];
        }
    }

    void ReadSteps(CborReader& reader) {
        const int block = static_cast<int>(m_data.blocks.size()) - 1;
        for (std::uint64_t left = reader.NextArray("steps"); left > 0; --left) {
            const std::size_t at = reader.GetPosition();
            ReadStep(reader, {block, at, false});
        }
    }

    void ReadStep(CborReader& reader, TrackEntry entry) {
        std::uint64_t left = reader.NextMap("a step");
        if (left == 0 || reader.NextText("a key") != "step")
            reader.Fail("a step has to begin with its number, \"step\"");
        const int step = static_cast<int>(reader.NextWhole("step", GetNextStep(), mostSteps));
        for (const int body : std::exchange(m_waiting, {}))
            m_data.bodies[static_cast<std::size_t>(body)].createdAfter = step;
        for (const int joint : std::exchange(m_waitingJoints, {})) {
            m_data.joints[static_cast<std::size_t>(joint)].createdAfter = step;
        }
        for (--left; left > 0; --left) {
            const std::string_view key = reader.NextText("a key");
            if (key == "key") {
                entry.isKey = reader.NextFlag("key");
            } else if (key == "dt") {
                const float dt = reader.NextFloat("dt");
                if (!(std::isfinite(dt) && dt >= 0.0f)) reader.Fail("dt: give a finite number that is not negative");
            } else if (key == "nodes") {
                // None of an engine whose interface does not give its tree.
                m_data.info.hasNodes = !reader.NextBytes("nodes").empty() || m_data.info.hasNodes;
            } else if (key == "marks") {
                const std::uint64_t marks = reader.NextArray("marks");
                for (std::uint64_t i = 0; i < marks; ++i) (void)reader.NextText("a mark");
                m_data.info.marks += marks;
            } else if (!ReadObjectsOf(reader, key, step)) {
                m_data.info.hasContacts = m_data.info.hasContacts || key == "contacts";
                m_data.info.hasStages = m_data.info.hasStages || key == "stages";
                reader.Skip();
            }
        }
        m_data.steps.push_back(step);
        m_data.entries.push_back(entry);
    }

    /// Objects that came and went in steps that are not in the file.
    void ReadObjects(CborReader& reader) {
        for (std::uint64_t left = reader.NextMap("objects"); left > 0; --left) {
            const std::string_view key = reader.NextText("a key");
            if (!ReadObjectsOf(reader, key, GetNextStep())) reader.Skip();
        }
        // They are there from the step that follows, whose number is not known yet.
        for (std::size_t i = 0; i < m_data.bodies.size(); ++i) {
            if (m_data.bodies[i].createdAfter == GetNextStep()) m_waiting.push_back(static_cast<int>(i));
        }
        for (std::size_t i = 0; i < m_data.joints.size(); ++i) {
            if (m_data.joints[i].createdAfter == GetNextStep()) m_waitingJoints.push_back(static_cast<int>(i));
        }
    }

    /// False if the key is not about objects.
    bool ReadObjectsOf(CborReader& reader, std::string_view key, int step) {
        if (key == "created") {
            for (std::uint64_t left = reader.NextArray("created"); left > 0; --left) ReadCreated(reader, step);
        } else if (key == "joints") {
            for (std::uint64_t left = reader.NextArray("joints"); left > 0; --left) ReadJoint(reader, step);
        } else if (key == "destroyed") {
            ReadDestroyed(reader, m_data.bodies, step);
        } else if (key == "destroyedJoints") {
            ReadDestroyed(reader, m_data.joints, step);
        } else if (key == "names") {
            for (std::uint64_t left = reader.NextArray("names"); left > 0; --left) {
                if (reader.NextArray("a name") != 2) reader.Fail("give a name as [number, text]");
                const int body = KnownIndex(reader, m_data.bodies);
                const std::string_view name = reader.NextText("a name");
                m_data.bodies[static_cast<std::size_t>(body)].name = name;
                m_data.bodyUsers[body]["name"] = name;
            }
        } else {
            return false;
        }
        return true;
    }

    template <typename Object>
    int KnownIndex(CborReader& reader, const std::vector<Object>& objects) {
        const std::int64_t number = reader.NextWhole("the number of an object", 0, mostNumber);
        const int index = IndexOf(objects, static_cast<double>(number));
        if (index < 0) reader.Fail(fmt::format("there is no object {}", number));
        return index;
    }

    template <typename Object>
    void ReadDestroyed(CborReader& reader, std::vector<Object>& objects, int step) {
        for (std::uint64_t left = reader.NextArray("destroyed"); left > 0; --left) {
            const int index = KnownIndex(reader, objects);
            Object& object = objects[static_cast<std::size_t>(index)];
            if (object.destroyedAfter >= 0) reader.Fail("an object is destroyed twice");
            object.destroyedAfter = step;
        }
    }

    template <typename Object>
    std::int64_t NewNumber(CborReader& reader, const std::vector<Object>& objects) {
        return reader.NextWhole("id", objects.empty() ? 0 : objects.back().number + 1, mostNumber);
    }

    void ReadCreated(CborReader& reader, int step) {
        TrackBody body;
        body.number = -1;
        body.createdAfter = step;
        JsonNode definition;
        nlohmann::ordered_json user;
        for (std::uint64_t left = reader.NextMap("a body that is created"); left > 0; --left) {
            const std::string_view key = reader.NextText("a key");
            if (key == "id") {
                body.number = NewNumber(reader, m_data.bodies);
            } else if (key == "was") {
                body.was = reader.NextWhole("was", 0, mostNumber);
            } else if (key == "userData") {
                user["userData"] = reader.NextWhole("userData", 0, mostNumber);
            } else if (key == "body") {
                definition = reader.NextTree();
            } else {
                reader.Skip();
            }
        }
        if (body.number < 0 || definition.kind != JsonNode::Kind::object) reader.Fail("give id and body");
        if (!user.is_null()) m_data.bodyUsers[static_cast<int>(m_data.bodies.size())] = std::move(user);
        m_data.bodies.push_back(std::move(body));
        ItemOf(m_root, "bodies").items.push_back(std::move(definition));
    }

    void ReadJoint(CborReader& reader, int step) {
        TrackJoint joint;
        joint.number = -1;
        joint.createdAfter = step;
        JsonNode definition;
        for (std::uint64_t left = reader.NextMap("a joint that is created"); left > 0; --left) {
            const std::string_view key = reader.NextText("a key");
            if (key == "id") {
                joint.number = NewNumber(reader, m_data.joints);
            } else if (key == "joint") {
                definition = reader.NextTree();
            } else {
                reader.Skip();
            }
        }
        if (joint.number < 0 || definition.kind != JsonNode::Kind::object) reader.Fail("give id and joint");
        // Numbers become indices, which is what scenes have.
        for (std::size_t i = 0; i < definition.keys.size(); ++i) {
            const std::string_view key = definition.keys[i];
            const bool isBody = key == "bodyA" || key == "bodyB", isJoint = key == "joint1" || key == "joint2";
            if (!isBody && !isJoint) continue;
            double& number = definition.items[i].number;
            number = isBody ? IndexOf(m_data.bodies, number) : IndexOf(m_data.joints, number);
            if (number < 0) reader.Fail(fmt::format("{}: there is no such object", key));
        }
        m_data.joints.push_back(joint);
        ItemOf(m_root, "joints").items.push_back(std::move(definition));
    }

    void FinishParts() {
        m_data.parts = ReadScene(m_root, m_data.source);
        m_root = {};
    }

    TrackFile::Data& m_data;
    JsonNode m_root;  ///< the scene with all that came later
    std::string m_context;
    int m_number = 0;
    bool m_hasHeader = false;
    std::vector<int> m_waiting, m_waitingJoints;  ///< created between two steps
};

}  // namespace

bool IsTrack(std::string_view bytes) { return bytes.starts_with(magic); }

void TrackFile::Data::BuildIndex() { Indexer(*this).Run(); }

CborReader TrackFile::Data::Open(int index) {
    const TrackBlock& block = blocks[static_cast<std::size_t>(index)];
    const ByteSpan payload = AsBytes(bytes).subspan(block.payloadAt, block.payloadSize);
    const std::string context = fmt::format("{}: record {}", source, block.number);
    if (block.inflatedSize == 0) return {payload, context, block.payloadAt};
    CborReader outer(payload, context, block.payloadAt);
    if (openBlock != index) {
        (void)outer.NextMap("a record");
        (void)outer.Next();
        (void)outer.NextArray("deflated");
        (void)outer.Next();
        const ByteSpan deflated = outer.NextBytes("the deflated bytes");
        openBlock = -1;
        inflated.resize(block.inflatedSize);
        uLongf size = static_cast<uLongf>(inflated.size());
        const int result = uncompress(inflated.data(), &size, deflated.data(), static_cast<uLong>(deflated.size()));
        if (result != Z_OK || size != inflated.size()) outer.Fail("zlib cannot inflate it; record it again");
        openBlock = index;
    }
    return {inflated, context + ", inflated", 0};
}

TrackFile ReadTrackFile(const std::filesystem::path& file) {
    return TrackFile(ReadText(file, "give a *.track file"), file.string());
}

}  // namespace testbed
