// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Scene data has the same bits in every build and on every machine, or results could not be compared: a hash of each
// scene at its default size. Another hash means another scene: correct the number only with the scene's description.

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <type_traits>

#include "scenes/build.h"
#include "scenes/catalog.h"

namespace scenes {
namespace {

/// FNV-1a over whole words; −0 and 0 are one value.
class Hasher {
public:
    template <typename... Values>
    void Add(Values... values) {
        (AddOne(values), ...);
    }
    [[nodiscard]] uint64_t Get() const { return m_hash; }

private:
    void AddOne(float value) { AddOne(std::bit_cast<uint32_t>(value + 0.0f)); }
    void AddOne(Vec2 value) { AddOne(value.x), AddOne(value.y); }
    template <typename T>
    requires std::is_integral_v<T> || std::is_enum_v<T>
    void AddOne(T value) {
        m_hash = (m_hash ^ static_cast<uint64_t>(value)) * 0x100000001B3u;
        m_hash ^= m_hash >> 29;
    }

    uint64_t m_hash = 0xCBF29CE484222325u;
};

void AddShape(const Shape& shape, Hasher& hash) {
    hash.Add(shape.type, shape.radius, shape.center, shape.halfExtents, shape.angle, shape.opening);
    hash.Add(shape.firstChainVertex, shape.chainVertexCount, shape.vertexCount);
    for (const Vec2 vertex : shape.Vertices()) hash.Add(vertex);
}

uint64_t HashOf(const Scene& scene) {
    Hasher hash;
    hash.Add(scene.gravity, scene.timeStep);
    for (const Body& b : scene.bodies) {
        hash.Add(b.type, b.bullet, b.allowSleep, b.awake, b.fixedRotation, b.position, b.angle, b.linearVelocity);
        hash.Add(b.angularVelocity, b.linearDamping, b.angularDamping, b.gravityScale, b.firstFixture, b.fixtureCount);
    }
    for (const Fixture& f : scene.fixtures) {
        AddShape(f.shape, hash);
        hash.Add(f.density, f.friction, f.restitution, f.tangentSpeed, f.isSensor, f.categoryBits, f.maskBits);
        hash.Add(f.groupIndex);
    }
    for (const Joint& j : scene.joints) {
        hash.Add(j.type, j.collideConnected, j.enableMotor, j.enableLimit, j.bodyA, j.bodyB, j.localAnchorA);
        hash.Add(j.localAnchorB, j.localAxisA, j.referenceAngle, j.lowerAngle, j.upperAngle, j.lowerTranslation);
        hash.Add(j.upperTranslation, j.motorSpeed, j.maxMotorTorque, j.maxMotorForce, j.maxForce, j.maxTorque);
        hash.Add(j.stiffness, j.damping, j.length, j.minLength, j.maxLength, j.linearOffset, j.angularOffset);
        hash.Add(j.correctionFactor, j.target, j.groundAnchorA, j.groundAnchorB, j.lengthA, j.lengthB, j.ratio);
        hash.Add(j.joint1, j.joint2);
    }
    for (const Spawn& s : scene.spawns) hash.Add(s.afterStep, s.body);
    for (const Vec2 vertex : scene.chainVertices) hash.Add(vertex);
    return hash.Get();
}

struct Golden {
    std::string_view scene;
    uint64_t hash;
};
constexpr Golden golden[] = {
    {"tiles", 0xDFD2BD335FEA68BCu},
    {"add-pair-400", 0x602E0032DA6C8E48u},
    {"falling-squares", 0x3C4C42D80FBE0AA6u},
    {"falling-circles", 0xEC947752A7ACF249u},
    {"tumbler", 0xFDF6D255855761E5u},
    {"multi-fixture", 0xD27D09AFF175143Bu},
    {"add-pair", 0x0FBF8CF7B6254A08u},
    {"mild-n2", 0x42E24DA4F7CC09F4u},
    {"n2", 0x5C7246570B329ADFu},
    {"mostly-static-single", 0x6DC3312BE0101D67u},
    {"mostly-static-multi", 0x0FB1BB60A4CC2ABEu},
    {"diagonal", 0xCF4B4E4118110701u},
    {"mixed", 0xC04BB087E786ABC7u},
    {"slow-explosion", 0x3680620E455BF42Cu},
    {"big-mobile", 0xFFAD59204734E181u},
    {"pyramid", 0x0EDFFE5712FF0F7Au},
    {"box-stack", 0xDC3986D39CF5E955u},
    {"domino-row", 0x2F47508874F751A6u},
    {"bridge", 0x4679AC0AB07997E3u},
    {"chain-heavy-end", 0xC205D5E8ED4BF66Cu},
    {"cantilever", 0x8925F3F1D55630B7u},
    {"car", 0x6D15CC72DFF41BDCu},
    {"ragdolls", 0x3A8BD3A8860C49D3u},
    {"conveyor", 0xE8410077C46A66EAu},
    {"pulley", 0x1532CE0CE94301F3u},
    {"gears", 0x8E35EC323477CBF9u},
    {"slider-crank", 0x12F6F9AC109D2D78u},
    {"web", 0xE8EE4A53081B423Au},
    {"character-corner-cases", 0x17A4D8CBD33D60D1u},
    {"sensors", 0xA2CA595B0B24FE31u},
    {"ray-cast-playground", 0x5BCEB16D2EF5128Du},
    {"restitution-row", 0xD2CA8A8950625519u},
    {"friction-row", 0x3B30245B30BAAF0Bu},
    {"convex-shapes", 0xE348A392D6E25823u},
    {"bin", 0x1857445D259269EEu},
    {"bullets", 0x7C5493C3240D70ABu},
    {"platformer", 0xC9B5A24EF7D3A37Bu},
    {"cars", 0x42ADF120EF33B305u},
    {"joint-distance", 0x42E07533085A9CB8u},
    {"joint-friction", 0xEBDD683A1E61AD01u},
    {"joint-gear", 0xA681E6F64EC7D161u},
    {"joint-motor", 0x8D19E11DE55C14B3u},
    {"joint-mouse", 0x5885C66CB67CB898u},
    {"joint-prismatic", 0xB54D93C1CAF4A481u},
    {"joint-pulley", 0xAD591BBF5C0E7F48u},
    {"joint-revolute", 0xF696A8A259B5F32Au},
    {"joint-weld", 0x30FBA93A9D965D32u},
    {"joint-wheel", 0x15C9D8FA8E3E8251u},
};

TEST(Data, HasTheSameBitsInEveryBuild) {
    EXPECT_EQ(std::size(golden), Catalog().size());
    for (const SceneInfo& info : Catalog()) {
        const uint64_t hash = HashOf(Build(info.name));
        const auto* known = std::ranges::find(golden, info.name, &Golden::scene);
        ASSERT_NE(known, std::end(golden)) << info.name << ": add it with " << std::hex << hash;
        EXPECT_EQ(known->hash, hash) << info.name << std::hex << " is now 0x" << hash;
    }
}

}  // namespace
}  // namespace scenes
