// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The track format as its writers need it: bytes, CBOR (RFC 8949) and JSON text, the packed states of bodies,
// checksums, and the file. C++11, the standard library alone; SCREE_CAPTURE_ZLIB, if defined, deflates blocks with
// zlib, SCREE_CAPTURE_NO_THREAD packs and writes them in Step.
//
// A track is `trackMagic`, then records: length and CRC-32 of the payload (32 bits each, little-endian), and the
// payload, one CBOR map with one key. All maps, arrays and strings have their length in front; keys are text.
//
//     {"header": {format, version, writer, engine, timeStep, scene}}
//     {"steps": [{step, dt, key?, h?, bodies?, created?, destroyed?, joints?, destroyedJoints?, names?, marks?,
//                 contacts?, contactCount?, nodes?, stages?}, …]}
//     {"objects": {created?, destroyed?, joints?, destroyedJoints?, names?}}
//     {"deflated": [length, bytes]}
//
// The header is the first record. Its `scene` is what a scene file holds; bodies and joints are numbered in its order.
// `steps` is a block of steps. `objects` is what happened since the last step that was kept, if steps were left out.
// `deflated` is one of these payloads, deflated by zlib.
//
// `created` is a list of {id, was?, userData?, body}, `joints` of {id, joint}, `names` of [id, text]. Bodies and joints
// have the scene's form and refer to others by their numbers. Numbers grow and are never used again. `was` is the body
// that this one replaces, after its fixtures or type changed.
//
// `bodies` are the packed states of the bodies that changed, one after the other; bytes are little-endian:
//
//     byte c: lengths of x, y and angle as (c % 5), (c / 5 % 5), (c / 25 % 5); c / 125 = 1: a number follows
//     byte d: lengths of vx, vy and the angular speed in the same way; d / 125 = 1: awake
//     the number, if it follows, as a zigzag varint, less the number of the body before; else that number less 1
//     six residuals of 0 to 4 bytes
//
// A residual is the zigzag of (ordinal of the value − ordinal of what was predicted). An ordinal is a float's bits as a
// 32-bit whole number, all but the sign bit flipped if that is set. The prediction of a velocity is the last one. That
// of a position is the float nearest to last + h · new velocity, computed in double (products are exact there).
// Operands and result below the smallest normal float count as 0 of their sign. Where h is 0 or the result is not
// finite, the prediction is the last position. h is dt unless given. In a step with `key` all bodies are first set back
// to how they were created, and h is 0.
//
// `contacts` holds for each touching contact the varints body, fixture, child of A, then of B. Then come a byte (number
// of points + 4 if a sensor) and the normal. Of each point come x, y, separation, normal and tangent impulse, as
// floats.
//
// `nodes` is the tree in pre-order: a node, the subtree of its first child, that of its second. For each node it has a
// byte (1: leaf), the box (lower x, y, upper x, y), and of a leaf the varints body, fixture, child.

#pragma once

#include <array>
#include <cerrno>
#include <cfloat>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>
#include <vector>
#ifdef SCREE_CAPTURE_ZLIB
#include <zlib.h>
#endif

namespace scree_capture {

/// How a world is recorded.
struct Options {
    bool contacts = false;  ///< touching contacts with their points and impulses
    bool tree = false;      ///< the nodes of the engine's own tree
    bool stages = false;    ///< the engine's times of each step
    /// Seconds to keep in memory, none of which are written before Save; 0: everything is written as it comes.
    double keepLast = 0.0;
    /// Bytes that may wait for the disk, or be kept. Steps that find no room are left out of the track.
    std::size_t memory = 64u << 20;
    int velocityIterations = 8, positionIterations = 3;  ///< that the program steps with: for running the scene again
};

namespace detail {

using Bytes = std::vector<unsigned char>;

static const unsigned char trackMagic[8] = {0x89, 'T', 'R', 'A', 'C', 'K', '\r', '\n'};

inline std::uint32_t BitsOf(float value) {
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}
inline float FloatOf(std::uint32_t bits) {
    float value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

inline void PutLittle32(Bytes& out, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<unsigned char>(value >> shift));
}
inline void PutVarint(Bytes& out, std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) out.push_back(static_cast<unsigned char>(value | 0x80));
    out.push_back(static_cast<unsigned char>(value));
}

/// The same at a place that has room: the place behind it is returned.
inline unsigned char* PutFloat(unsigned char* out, float value) {
    const std::uint32_t bits = BitsOf(value);
    for (int i = 0; i < 4; ++i) out[i] = static_cast<unsigned char>(bits >> 8 * i);
    return out + 4;
}
inline unsigned char* PutVarint(unsigned char* out, std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) *out++ = static_cast<unsigned char>(value | 0x80);
    *out++ = static_cast<unsigned char>(value);
    return out;
}

/// CRC-32 of zlib, eight bytes at a time.
class Crc32 {
public:
    static std::uint32_t Of(const unsigned char* data, std::size_t size) {
        static const Crc32 tables;
        const std::array<std::array<std::uint32_t, 256>, 8>& t = tables.m_tables;
        std::uint32_t crc = 0xFFFFFFFFu;
        for (; size >= 8; size -= 8, data += 8) {
            const std::uint32_t low =
                crc ^ (data[0] | static_cast<std::uint32_t>(data[1]) << 8 | static_cast<std::uint32_t>(data[2]) << 16 |
                       static_cast<std::uint32_t>(data[3]) << 24);
            crc = t[7][low & 0xFF] ^ t[6][low >> 8 & 0xFF] ^ t[5][low >> 16 & 0xFF] ^ t[4][low >> 24] ^ t[3][data[4]] ^
                  t[2][data[5]] ^ t[1][data[6]] ^ t[0][data[7]];
        }
        for (; size > 0; --size, ++data) crc = crc >> 8 ^ t[0][(crc ^ *data) & 0xFF];
        return ~crc;
    }

private:
    Crc32() {
        for (std::uint32_t i = 0; i < 256; ++i) {
            std::uint32_t crc = i;
            for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1u ? 0xEDB88320u : 0u);
            m_tables[0][i] = crc;
        }
        for (std::size_t k = 1; k < 8; ++k) {
            for (std::size_t i = 0; i < 256; ++i) {
                const std::uint32_t last = m_tables[k - 1][i];
                m_tables[k][i] = last >> 8 ^ m_tables[0][last & 0xFF];
            }
        }
    }
    std::array<std::array<std::uint32_t, 256>, 8> m_tables;
};

/// Items of CBOR, one after the other. Containers that are ended get their length then.
class CborWriter {
public:
    void BeginMap() { Begin(0xBA, 2); }
    void EndMap() { End(); }
    void BeginArray() { Begin(0x9A, 1); }
    void EndArray() { End(); }
    void Key(const char* name) { Text(name, std::strlen(name)); }
    void Value(float value) {
        Count();
        m_bytes.push_back(0xFA);
        Big32(BitsOf(value));
    }
    void Value(bool value) {
        Count();
        m_bytes.push_back(value ? 0xF5 : 0xF4);
    }
    void Value(std::int64_t value) {
        Count();
        value < 0 ? Head(0x20, static_cast<std::uint64_t>(-1 - value)) : Head(0, static_cast<std::uint64_t>(value));
    }
    void Value(const char* text) { Text(text, std::strlen(text)); }
    void Value(const std::string& text) { Text(text.data(), text.size()); }

    /// Begins a string of bytes that the caller appends to `GetBytes()`; `EndBytes` gets what this returned.
    std::size_t BeginBytes() {
        Count();
        m_bytes.push_back(0x5A);
        Big32(0);
        return m_bytes.size();
    }
    void EndBytes(std::size_t begin) { Patch(begin - 4, static_cast<std::uint32_t>(m_bytes.size() - begin)); }
    /// An item that is already coded.
    void Raw(const Bytes& item) {
        Count();
        m_bytes.insert(m_bytes.end(), item.begin(), item.end());
    }
    Bytes& GetBytes() { return m_bytes; }
    const Bytes& GetBytes() const { return m_bytes; }
    void Patch(std::size_t at, std::uint32_t value) {
        for (std::size_t i = 0; i < 4; ++i) m_bytes[at + i] = static_cast<unsigned char>(value >> (24 - 8 * i));
    }
    void Clear() {
        m_bytes.clear();
        m_open.clear();
    }

private:
    struct Open {
        std::size_t countAt;
        std::uint32_t items, perEntry;
    };
    void Begin(unsigned char head, std::uint32_t perEntry) {
        Count();
        m_bytes.push_back(head);
        m_open.push_back(Open{m_bytes.size(), 0, perEntry});
        Big32(0);
    }
    void End() {
        const Open open = m_open.back();
        m_open.pop_back();
        Patch(open.countAt, open.items / open.perEntry);
    }
    void Count() {
        if (!m_open.empty()) ++m_open.back().items;
    }
    void Text(const char* text, std::size_t size) {
        Count();
        Head(0x60, size);
        m_bytes.insert(m_bytes.end(), text, text + size);
    }
    void Head(unsigned char major, std::uint64_t value) {
        if (value < 24) {
            m_bytes.push_back(static_cast<unsigned char>(major | value));
            return;
        }
        const int size = value < 0x100 ? 0 : value < 0x10000 ? 1 : value < 0x100000000u ? 2 : 3;
        m_bytes.push_back(static_cast<unsigned char>(major | (24 + size)));
        for (int shift = (8 << size) - 8; shift >= 0; shift -= 8) {
            m_bytes.push_back(static_cast<unsigned char>(value >> shift));
        }
    }
    void Big32(std::uint32_t value) {
        for (int shift = 24; shift >= 0; shift -= 8) m_bytes.push_back(static_cast<unsigned char>(value >> shift));
    }

    Bytes m_bytes;
    std::vector<Open> m_open;
};

/// The same calls as JSON text; what stands in a list or map of the first two levels begins a line.
class JsonWriter {
public:
    void BeginMap() { Begin('{'); }
    void EndMap() { End('}'); }
    void BeginArray() { Begin('['); }
    void EndArray() { End(']'); }
    void Key(const char* name) {
        Separate();
        Quote(name, std::strlen(name));
        m_text += ": ";
        m_isAfterKey = true;
    }
    void Value(float value) {
        Separate();
        m_text += Shortest(value);
    }
    void Value(bool value) {
        Separate();
        m_text += value ? "true" : "false";
    }
    void Value(std::int64_t value) {
        Separate();
        m_text += std::to_string(value);
    }
    void Value(const char* text) {
        Separate();
        Quote(text, std::strlen(text));
    }
    void Value(const std::string& text) {
        Separate();
        Quote(text.data(), text.size());
    }
    const std::string& GetText() const { return m_text; }

    /// The shortest decimal that reads back to the same float, in any locale. Numbers that are not finite, which JSON
    /// does not have, become null: readers refuse them by their place.
    static std::string Shortest(float value) {
        if (!std::isfinite(value)) return "null";
        char text[40];
        for (int digits = 6; digits <= 9; ++digits) {
            std::snprintf(text, sizeof text, "%.*g", digits, static_cast<double>(value));
            if (BitsOf(std::strtof(text, nullptr)) == BitsOf(value)) break;
        }
        std::string result(text);
        const std::lconv* locale = std::localeconv();
        const std::string point = locale != nullptr && locale->decimal_point != nullptr ? locale->decimal_point : ".";
        const std::size_t at = result.find(point);
        if (!point.empty() && at != std::string::npos) result.replace(at, point.size(), ".");
        // "-0" would be read as the whole number 0.
        return result == "-0" ? "-0.0" : result;
    }

private:
    void Begin(char bracket) {
        Separate();
        m_text += bracket;
        ++m_depth;
        m_isFirst = true;
    }
    void End(char bracket) {
        --m_depth;
        if (m_depth < 2) m_text += '\n';
        m_text += bracket;
        if (m_depth == 0) m_text += '\n';
        m_isFirst = false;
    }
    void Separate() {
        if (m_isAfterKey) {
            m_isAfterKey = false;
            return;
        }
        if (m_depth > 0 && !m_isFirst) m_text += ',';
        if (m_depth > 0) m_text += m_depth <= 2 ? "\n" : m_isFirst ? "" : " ";
        m_isFirst = false;
    }
    void Quote(const char* text, std::size_t size) {
        m_text += '"';
        for (std::size_t i = 0; i < size; ++i) {
            const unsigned char c = static_cast<unsigned char>(text[i]);
            if (c == '"' || c == '\\') {
                m_text += '\\';
                m_text += static_cast<char>(c);
            } else if (c < 0x20) {
                char escaped[8];
                std::snprintf(escaped, sizeof escaped, "\\u%04x", c);
                m_text += escaped;
            } else {
                m_text += static_cast<char>(c);
            }
        }
        m_text += '"';
    }

    std::string m_text;
    int m_depth = 0;
    bool m_isFirst = true, m_isAfterKey = false;
};

/// Pose and velocity of a body as bits: x, y, angle, vx, vy, angular speed.
struct State {
    std::uint32_t bits[6];
    bool awake;

    /// Position, angle, and their velocities, one by one: copied at once, they would wait for the last to be stored.
    template <typename Vec2>
    void Set(const Vec2& position, float angle, const Vec2& velocity, float spin) {
        const float values[6] = {position.x, position.y, angle, velocity.x, velocity.y, spin};
        for (int i = 0; i < 6; ++i) bits[i] = BitsOf(values[i]);
    }
    bool IsSame(const State& other) const {
        return std::memcmp(bits, other.bits, sizeof bits) == 0 && awake == other.awake;
    }
};

inline std::uint32_t OrdinalOf(std::uint32_t bits) { return bits ^ ((0u - (bits >> 31)) & 0x7FFFFFFFu); }

/// Zero of its sign instead of a number below the smallest normal one, which some programs flush and others do not.
inline std::uint32_t WithoutDenormals(std::uint32_t bits) {
    return (bits & 0x7F800000u) == 0 ? bits & 0x80000000u : bits;
}

/// What a position is expected to be after a step of h at a velocity.
inline std::uint32_t Predict(std::uint32_t last, std::uint32_t velocity, double h) {
    if (h == 0.0) return last;
    const double way = h * static_cast<double>(FloatOf(WithoutDenormals(velocity)));
    const float next = static_cast<float>(static_cast<double>(FloatOf(WithoutDenormals(last))) + way);
    const std::uint32_t bits = BitsOf(next);
    return (bits & 0x7F800000u) == 0x7F800000u ? last : WithoutDenormals(bits);
}

/// Whether prediction computes here what it does everywhere: rounding each operation to double.
inline bool CanPredict() { return FLT_EVAL_METHOD == 0 || FLT_EVAL_METHOD == 1; }

/// The least bytes that hold a number, without asking what a processor would have to guess.
inline unsigned LengthOf(std::uint32_t value) {
#ifdef __GNUC__
    const int bits = 63 - __builtin_clzll(static_cast<unsigned long long>(value) << 1 | 1u);
    return (static_cast<unsigned>(bits) + 7u) / 8u;
#else
    return static_cast<unsigned>(value > 0) + static_cast<unsigned>(value > 0xFFu) +
           static_cast<unsigned>(value > 0xFFFFu) + static_cast<unsigned>(value > 0xFFFFFFu);
#endif
}

/// The most bytes that a packed state takes.
static const std::size_t mostStateBytes = 2 + 10 + 24;

/// Writes a state at `out`, which has room for mostStateBytes + 4, and returns its end.
inline unsigned char* PackState(unsigned char* out, std::int64_t number, std::int64_t lastNumber, const State& now,
                                const State& last, double h) {
    std::uint32_t predicted[6], residuals[6];
    unsigned lengths[6];
    for (int i = 0; i < 3; ++i) predicted[i] = Predict(last.bits[i], now.bits[i + 3], h);
    for (int i = 3; i < 6; ++i) predicted[i] = last.bits[i];
    for (int i = 0; i < 6; ++i) {
        const std::uint32_t difference = OrdinalOf(now.bits[i]) - OrdinalOf(predicted[i]);
        residuals[i] = difference << 1 ^ (0u - (difference >> 31));
        lengths[i] = LengthOf(residuals[i]);
    }
    const bool isFar = number != lastNumber - 1;
    *out++ = static_cast<unsigned char>(lengths[0] + 5 * lengths[1] + 25 * lengths[2] + (isFar ? 125 : 0));
    *out++ = static_cast<unsigned char>(lengths[3] + 5 * lengths[4] + 25 * lengths[5] + (now.awake ? 125 : 0));
    if (isFar) {
        const std::int64_t difference = number - lastNumber;
        out = PutVarint(out, static_cast<std::uint64_t>(difference < 0 ? -2 * difference - 1 : 2 * difference));
    }
    for (int i = 0; i < 6; ++i) {
        for (unsigned k = 0; k < 4; ++k) out[k] = static_cast<unsigned char>(residuals[i] >> 8 * k);
        out += lengths[i];
    }
    return out;
}

/// A track that payloads are appended to.
class Output {
public:
    explicit Output(const std::string& path) {
        m_file = std::fopen(path.c_str(), "wb");
        if (m_file == nullptr) {
            m_error = path + ": cannot be written: " + std::generic_category().message(errno);
            return;
        }
        Write(trackMagic, sizeof trackMagic);
    }
    ~Output() {
        if (m_file != nullptr) std::fclose(m_file);
    }
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;

    /// A payload with its length and checksum, deflated where zlib is at hand.
    void Append(const Bytes& payload, bool mayDeflate) {
#ifdef SCREE_CAPTURE_ZLIB
        CborWriter deflated;
        if (mayDeflate && Deflate(payload, deflated)) {
            AppendAsIs(deflated.GetBytes());
            return;
        }
#else
        (void)mayDeflate;
#endif
        AppendAsIs(payload);
    }
    const std::string& GetError() const { return m_error; }

private:
#ifdef SCREE_CAPTURE_ZLIB
    /// False if it gains nothing.
    static bool Deflate(const Bytes& payload, CborWriter& deflated) {
        uLongf size = compressBound(static_cast<uLong>(payload.size()));
        Bytes packed(size);
        if (compress2(packed.data(), &size, payload.data(), static_cast<uLong>(payload.size()), 1) != Z_OK)
            return false;
        packed.resize(size);
        deflated.BeginMap();
        deflated.Key("deflated");
        deflated.BeginArray();
        deflated.Value(static_cast<std::int64_t>(payload.size()));
        const std::size_t begin = deflated.BeginBytes();
        deflated.GetBytes().insert(deflated.GetBytes().end(), packed.begin(), packed.end());
        deflated.EndBytes(begin);
        deflated.EndArray();
        deflated.EndMap();
        return deflated.GetBytes().size() < payload.size();
    }
#endif
    void AppendAsIs(const Bytes& payload) {
        Bytes head;
        PutLittle32(head, static_cast<std::uint32_t>(payload.size()));
        PutLittle32(head, Crc32::Of(payload.data(), payload.size()));
        Write(head.data(), head.size());
        Write(payload.data(), payload.size());
        if (m_error.empty() && std::fflush(m_file) != 0) Fail();
    }
    void Write(const unsigned char* data, std::size_t size) {
        if (m_error.empty() && std::fwrite(data, 1, size, m_file) != size) Fail();
    }
    void Fail() { m_error = "the track cannot be written to its end: " + std::generic_category().message(errno); }

    std::FILE* m_file = nullptr;
    std::string m_error;
};

}  // namespace detail
}  // namespace scree_capture
