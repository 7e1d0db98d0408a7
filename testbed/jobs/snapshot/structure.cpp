// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a snapshot consists of, and the difference of two such descriptions.

#include "testbed/jobs/snapshot/structure.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "testbed/base/hash.h"
#include "testbed/base/text.h"
#include "testbed/jobs/snapshot/result.h"

namespace testbed {

namespace {

using Json = nlohmann::ordered_json;

// With these a sidecar stays below 10 KB or not much above.
constexpr std::size_t maxPoses = 220, maxBoxes = 120, maxContacts = 300, maxHashes = 600;
constexpr std::size_t hashLength = 4;

/// Bits in, 24 bits as four characters out (folded): enough to see that something changed, no more.
class ShortHash {
public:
    void Add(uint32_t bits) { m_hash.AddBytes(bits); }
    void Add(int value) { Add(static_cast<uint32_t>(value)); }
    void Add(float value) { Add(std::bit_cast<uint32_t>(value + 0.0f)); }  // −0 counts as 0
    void Add(const Vec2& v) {
        Add(v.x);
        Add(v.y);
    }
    [[nodiscard]] std::string GetText() const {
        constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
        const uint64_t hash = m_hash.Get(), folded = hash ^ hash >> 24 ^ hash >> 48;
        std::string text;
        for (std::size_t i = 0; i < hashLength; ++i) text += digits[folded >> (6 * i) & 63u];
        return text;
    }

private:
    Fnv1a<uint64_t> m_hash;
};

/// Thousandths, or nan.
std::string Milli(double value) {
    if (!std::isfinite(value)) return "nan";
    return fmt::format("{}", std::llround(std::clamp(value * 1000, -1e15, 1e15)));
}

void Join(std::string& list, const std::string& entry) { list += (list.empty() ? "" : ",") + entry; }

void AddBody(ShortHash& hash, const BodyState& body) {
    hash.Add(body.position);
    hash.Add(body.sin);
    hash.Add(body.cos);
    hash.Add(body.linearVelocity);
    hash.Add(body.angularVelocity);
    hash.Add(static_cast<int>(body.awake));
}

void AddNode(ShortHash& hash, const NodeState& node) {
    hash.Add(node.box.lower);
    hash.Add(node.box.upper);
    hash.Add(node.parent);
    hash.Add(node.fixture);
    hash.Add(node.level);
}

/// Count, block and hashes: of each thing, or of blocks of them where there would be too many hashes.
template <typename Thing>
Json HashBlocks(const std::vector<Thing>& things, void (*add)(ShortHash&, const Thing&)) {
    const std::size_t block = things.size() / (maxHashes + 1) + 1;
    std::string hashes;
    for (std::size_t begin = 0; begin < things.size(); begin += block) {
        ShortHash hash;
        for (std::size_t i = begin; i < std::min(begin + block, things.size()); ++i) add(hash, things[i]);
        hashes += hash.GetText();
    }
    Json json = {{"count", things.size()}};
    if (block > 1) json["block"] = block;
    json["hashes"] = hashes;
    return json;
}

Json DescribeBodies(const Snapshot& snapshot) {
    Json bodies = HashBlocks(snapshot.bodies, AddBody);
    if (snapshot.bodies.size() > maxPoses) return bodies;
    std::string poses;
    for (const BodyState& body : snapshot.bodies) {
        const bool isAsleep = body.type != scenes::BodyType::isStatic && !body.awake;
        Join(poses, fmt::format("{} {} {}{}", Milli(body.position.x), Milli(body.position.y), Milli(body.angle),
                                isAsleep ? "s" : ""));
    }
    bodies["poses"] = poses;
    return bodies;
}

Json DescribeNodes(const Snapshot& snapshot) {
    Json nodes = HashBlocks(snapshot.nodes, AddNode);
    if (snapshot.nodes.size() > maxBoxes) return nodes;
    std::string boxes;
    for (const NodeState& node : snapshot.nodes) {
        const Box& box = node.box;
        Join(boxes, fmt::format("{} {} {} {} {}", node.level, Milli(box.lower.x), Milli(box.lower.y),
                                Milli(box.upper.x), Milli(box.upper.y)));
    }
    nodes["boxes"] = boxes;
    return nodes;
}

std::string DescribeFixture(const Snapshot& snapshot, int fixture) {
    const int body = snapshot.fixtures[static_cast<std::size_t>(fixture)].body;
    return body == fixture ? fmt::format("{}", fixture) : fmt::format("{}.{}", fixture, body);
}

std::string HashContact(const ContactState& contact) {
    ShortHash hash;
    hash.Add(contact.normal);
    for (int i = 0; i < contact.pointCount; ++i) {
        hash.Add(contact.points[i]);
        hash.Add(contact.separations[i]);
        hash.Add(contact.normalImpulses[i]);
        hash.Add(contact.tangentImpulses[i]);
    }
    return hash.GetText();
}

Json DescribeContacts(const Snapshot& snapshot) {
    std::vector<const ContactState*> sorted;
    for (const ContactState& contact : snapshot.contacts) sorted.push_back(&contact);
    std::ranges::sort(sorted, {}, [](const ContactState* c) { return std::pair(c->fixtureA, c->fixtureB); });
    ShortHash all;
    std::string list;
    for (const ContactState* contact : sorted) {
        const std::string text = fmt::format("{}-{} {} {} {}", DescribeFixture(snapshot, contact->fixtureA),
                                             DescribeFixture(snapshot, contact->fixtureB),
                                             contact->touching ? 't' : 'n', contact->pointCount, HashContact(*contact));
        for (const char c : text) all.Add(static_cast<int>(c));
        Join(list, text);
    }
    Json contacts = {{"count", snapshot.contacts.size()}, {"hash", all.GetText()}};
    if (sorted.size() <= maxContacts) contacts["list"] = list;
    return contacts;
}

[[noreturn]] void Refuse(const std::string& problem = {}) {
    throw std::invalid_argument(fmt::format("a sidecar's structure is damaged{}{}; run `scree snapshot update`",
                                            problem.empty() ? "" : ": ", problem));
}

template <typename Number>
Number ReadNumber(std::string_view text) {
    const Parsed<Number> number = ParseNumber<Number>(text);
    if (!number) Refuse(number.problem);
    return *number;
}

/// The entries of a list with commas.
std::vector<std::string_view> SplitList(const Json& list) {
    const std::string& text = list.get_ref<const std::string&>();
    return text.empty() ? std::vector<std::string_view>() : Split(text, ',');
}

/// Thousandths in a sidecar as units; nan is null.
Json FromMilli(std::string_view text) { return text == "nan" ? Json(nullptr) : Json(ReadNumber<double>(text) / 1000); }

Json ParsePose(std::string_view text) {
    const bool awake = !text.ends_with('s');
    if (!awake) text.remove_suffix(1);
    const std::vector<std::string_view> words = Split(text, ' ');
    if (words.size() != 3) Refuse();
    return {{"x", FromMilli(words[0])}, {"y", FromMilli(words[1])}, {"angle", FromMilli(words[2])}, {"awake", awake}};
}

Json ParseBox(std::string_view text) {
    const std::vector<std::string_view> words = Split(text, ' ');
    if (words.size() != 5) Refuse();
    return {{"level", ReadNumber<int>(words[0])},
            {"box", {FromMilli(words[1]), FromMilli(words[2]), FromMilli(words[3]), FromMilli(words[4])}}};
}

/// Things numbered from 0, with a hash of each block of them and perhaps a value of each.
struct NumberedList {
    std::size_t count = 0, block = 1;
    std::string hashes;
    std::vector<std::string_view> values;  ///< in the JSON; empty: too many to keep

    NumberedList(const Json& json, const char* valuesKey)
        : count(json.at("count").get<std::size_t>()), hashes(json.at("hashes").get<std::string>()) {
        if (json.contains(valuesKey)) values = SplitList(json[valuesKey]);
        if (json.contains("block")) block = json["block"].get<std::size_t>();
        if (block == 0 || hashes.size() != (count + block - 1) / block * hashLength ||
            (!values.empty() && values.size() != count))
            Refuse();
    }
    /// Of the block of number i; another count makes other blocks, so the last, shorter one differs by its length.
    [[nodiscard]] std::string_view GetHash(std::size_t i) const {
        return std::string_view(hashes).substr(i / block * hashLength, hashLength);
    }
};

/// Counts of one kind of thing, and the first changes.
struct ChangeList {
    std::size_t changed = 0, added = 0, removed = 0;
    Json list = Json::array();

    void Add(Json entry, bool inExpected, bool inActual, Json expected, Json actual) {
        ++(inExpected && inActual ? changed : inActual ? added : removed);
        if (list.size() == maxListed) return;
        entry["change"] = inExpected && inActual ? "changed" : inActual ? "added" : "removed";
        entry["expected"] = std::move(expected);
        entry["actual"] = std::move(actual);
        list.push_back(std::move(entry));
    }
    [[nodiscard]] Json Finish(std::size_t expectedCount, std::size_t actualCount) {
        return {{"expected", expectedCount}, {"actual", actualCount},  {"changed", changed}, {"added", added},
                {"removed", removed},        {"list", std::move(list)}};
    }
};

Json CompareNumbered(const NumberedList& expected, const NumberedList& actual, Json (*parse)(std::string_view)) {
    ChangeList changes;
    const auto value = [&](const NumberedList& side, std::size_t i) {
        return i < side.values.size() ? parse(side.values[i]) : Json(nullptr);
    };
    for (std::size_t i = 0; i < std::max(expected.count, actual.count); ++i) {
        const bool inExpected = i < expected.count, inActual = i < actual.count;
        const bool isComparable = inExpected && inActual && expected.block == actual.block;
        if (isComparable && expected.GetHash(i) == actual.GetHash(i)) continue;
        const bool isListed = changes.list.size() < maxListed;
        changes.Add({{"index", i}}, inExpected, inActual, isListed ? value(expected, i) : Json(nullptr),
                    isListed ? value(actual, i) : Json(nullptr));
    }
    Json json = changes.Finish(expected.count, actual.count);
    json["block"] = std::max(expected.block, actual.block);
    return json;
}

using FixturePair = std::pair<std::string, std::string>;  // "7.5": fixture 7 of body 5

/// The numbers of fixture and body in "7.5", or in "7" for both.
std::pair<int, int> ParseFixture(std::string_view text) {
    const std::vector<std::string_view> numbers = Split(text, '.');
    if (numbers.size() > 2) Refuse();
    return {ReadNumber<int>(numbers.front()), ReadNumber<int>(numbers.back())};
}
int BodyOf(std::string_view fixture) { return ParseFixture(fixture).second; }

/// By the fixtures' numbers, as an engine lists them.
struct FixtureOrder {
    static std::pair<int, int> Key(const FixturePair& pair) {
        return {ParseFixture(pair.first).first, ParseFixture(pair.second).first};
    }
    bool operator()(const FixturePair& a, const FixturePair& b) const { return Key(a) < Key(b); }
};

/// Fixtures → "t 2 hash".
using ContactMap = std::map<FixturePair, std::string, FixtureOrder>;

ContactMap ParseContacts(const Json& json) {
    ContactMap contacts;
    for (const std::string_view entry : SplitList(json.at("list"))) {
        const std::size_t dash = entry.find('-'), space = entry.find(' ');
        if (dash == std::string::npos || space == std::string::npos || dash > space) Refuse();
        const FixturePair fixtures{entry.substr(0, dash), entry.substr(dash + 1, space - dash - 1)};
        contacts[fixtures] = entry.substr(space + 1);
    }
    return contacts;
}

Json ParseContact(const std::string* text) {
    if (text == nullptr) return nullptr;
    const std::vector<std::string_view> words = Split(*text, ' ');
    if (words.size() < 2) Refuse();
    return {{"touching", words[0] == "t"}, {"points", ReadNumber<int>(words[1])}};
}

Json CompareContacts(const Json& expectedJson, const Json& actualJson) {
    ChangeList changes;
    const auto expectedCount = expectedJson.at("count").get<std::size_t>();
    const auto actualCount = actualJson.at("count").get<std::size_t>();
    if (!expectedJson.contains("list") || !actualJson.contains("list")) {
        // Too many to keep: only that some changed is known.
        if (expectedJson.at("hash") != actualJson.at("hash")) changes.changed = std::min(expectedCount, actualCount);
        return changes.Finish(expectedCount, actualCount);
    }
    const ContactMap expected = ParseContacts(expectedJson), actual = ParseContacts(actualJson);
    ContactMap all = expected;
    all.insert(actual.begin(), actual.end());
    for (const auto& [pair, ignored] : all) {
        const auto find = [&pair = pair](const ContactMap& contacts) -> const std::string* {
            const auto place = contacts.find(pair);
            return place == contacts.end() ? nullptr : &place->second;
        };
        const std::string *before = find(expected), *after = find(actual);
        if (before != nullptr && after != nullptr && *before == *after) continue;
        const auto [fixtureA, fixtureB] = FixtureOrder::Key(pair);
        changes.Add({{"bodies", {BodyOf(pair.first), BodyOf(pair.second)}}, {"fixtures", {fixtureA, fixtureB}}},
                    before != nullptr, after != nullptr, ParseContact(before), ParseContact(after));
    }
    return changes.Finish(expectedCount, actualCount);
}

}  // namespace

Json DescribeStructure(const Snapshot& snapshot) {
    return {{"bodies", DescribeBodies(snapshot)},
            {"nodes", DescribeNodes(snapshot)},
            {"contacts", DescribeContacts(snapshot)}};
}

Json CompareStructures(const Json& expected, const Json& actual) {
    try {
        const auto compare = [&](const char* kind, const char* values, Json (*parse)(std::string_view)) {
            return CompareNumbered({expected.at(kind), values}, {actual.at(kind), values}, parse);
        };
        return {{"equal", expected == actual},
                {"bodies", compare("bodies", "poses", ParsePose)},
                {"nodes", compare("nodes", "boxes", ParseBox)},
                {"contacts", CompareContacts(expected.at("contacts"), actual.at("contacts"))}};
    } catch (const Json::exception&) {
        Refuse();
    }
}

}  // namespace testbed
