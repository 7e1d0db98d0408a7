// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a world can do. Every feature has a neutral value (damping 0, gravity scale 1, no joint, …), with which its code
// changes no bit of any result. So a world skips the code of features that nothing in it uses (Tsamis, 2020, §7.2, at
// run time). A fixed set says in advance which these are, and a build of the library can leave features out.

#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "scree/api.h"

namespace scree {

/// One thing that a world may or may not need. In brackets: who counts as a user.
enum class Feature : uint8_t {
    rotation,           ///< movers turn (movers without fixed rotation, or with a spin)
    friction,           ///< fixtures with friction or MixRule::custom; contacts that were given some
    restitution,        ///< fixtures with restitution or MixRule::custom; contacts that were given some
    tangentSpeed,       ///< fixtures with a tangent speed; contacts that were given one
    damping,            ///< dynamic bodies with linear or angular damping
    gravityScale,       ///< dynamic bodies whose gravity scale is not 1
    forces,             ///< dynamic bodies on which a force or torque acts in the next step
    speedLimit,         ///< WorldDef::maxTranslation or maxRotation is finite (the world)
    sleeping,           ///< movers that may fall asleep or are asleep
    joints,             ///< all joints
    springs,            ///< joints with a stiffness
    limits,             ///< joints with a limit that is on
    motors,             ///< joints with a motor that is on; motor joints
    continuousStatic,   ///< solid fixtures of static and kinematic bodies, with continuous collision on
    continuousBullet,   ///< bullets, with continuous collision on
    sensors,            ///< sensor fixtures
    filters,            ///< fixtures whose filter is not the default; a contact filter (the world)
    events,             ///< a contact listener (the world), fixtures that report, joints with a threshold
    polygons,           ///< fixtures with a PolygonShape or a ConvexShape
    edges,              ///< fixtures with an EdgeShape, those of chains included
    kinematicBodies,    ///< all kinematic bodies
    multiThreading,     ///< more than one worker, or a task system of the program (the world)
    rollingResistance,  ///< fixtures with rolling resistance
    motionLocks,        ///< dynamic bodies locked in x or y
};
inline constexpr int featureCount = 24;

inline constexpr std::array<const char*, featureCount> featureNames = {"rotation",
                                                                       "friction",
                                                                       "restitution",
                                                                       "tangentSpeed",
                                                                       "damping",
                                                                       "gravityScale",
                                                                       "forces",
                                                                       "speedLimit",
                                                                       "sleeping",
                                                                       "joints",
                                                                       "springs",
                                                                       "limits",
                                                                       "motors",
                                                                       "continuousStatic",
                                                                       "continuousBullet",
                                                                       "sensors",
                                                                       "filters",
                                                                       "events",
                                                                       "polygons",
                                                                       "edges",
                                                                       "kinematicBodies",
                                                                       "multiThreading",
                                                                       "rollingResistance",
                                                                       "motionLocks"};

constexpr const char* GetName(Feature feature) { return featureNames[static_cast<size_t>(feature)]; }
/// None for an unknown name.
constexpr std::optional<Feature> FeatureFromName(std::string_view name) {
    for (size_t i = 0; i < featureNames.size(); ++i) {
        if (featureNames[i] == name) return static_cast<Feature>(i);
    }
    return std::nullopt;
}

/// A set of features. A structural type, hence good as a template argument.
struct Features {
    uint32_t bits = 0;

    constexpr Features() = default;
    constexpr Features(std::initializer_list<Feature> list) {
        for (const Feature feature : list) bits |= BitOf(feature);
    }
    static constexpr Features FromBits(uint32_t bits) {
        Features set;
        set.bits = bits & ((1u << featureCount) - 1);
        return set;
    }
    static constexpr Features All() { return FromBits(~0u); }

    [[nodiscard]] constexpr bool Has(Feature feature) const { return (bits & BitOf(feature)) != 0; }
    [[nodiscard]] constexpr bool Contains(Features other) const { return (other.bits & ~bits) == 0; }
    [[nodiscard]] constexpr bool IsEmpty() const { return bits == 0; }
    /// The lowest member; the set is not empty.
    [[nodiscard]] constexpr Feature First() const { return static_cast<Feature>(std::countr_zero(bits)); }
    [[nodiscard]] constexpr Features With(Feature feature) const { return FromBits(bits | BitOf(feature)); }
    [[nodiscard]] constexpr Features Without(Feature feature) const { return FromBits(bits & ~BitOf(feature)); }
    constexpr Features& Add(Feature feature, bool condition = true) {
        if (condition) bits |= BitOf(feature);
        return *this;
    }

    friend constexpr Features operator|(Features a, Features b) { return FromBits(a.bits | b.bits); }
    friend constexpr Features operator&(Features a, Features b) { return FromBits(a.bits & b.bits); }
    friend constexpr Features operator-(Features a, Features b) { return FromBits(a.bits & ~b.bits); }
    friend constexpr bool operator==(const Features&, const Features&) = default;

private:
    static constexpr uint32_t BitOf(Feature feature) { return 1u << static_cast<unsigned>(feature); }
};

/// What this build of the library can model: everything, unless it was configured with SCREE_FEATURES.
#ifdef SCREE_COMPILED_FEATURES
inline constexpr Features compiledFeatures = Features::FromBits(SCREE_COMPILED_FEATURES);
#else
inline constexpr Features compiledFeatures = Features::All();
#endif

/// How a world decides what it models.
enum class FeatureMode : uint8_t {
    automatic,  ///< what its objects use at the moment
    full,       ///< everything, used or not: for comparisons
    fixed,      ///< WorldDef::features; a call that would use another is refused with ErrorCode::missingFeature
};

/// How many objects use each feature, by Feature.
using FeatureUsers = std::array<int, featureCount>;

/// Which of the compiled kernels a step runs; what is off is left out.
struct KernelSet {
    bool bodyForces;   ///< damping, gravity scale and forces of bodies
    bool speedLimit;   ///< caps on motion
    bool friction;     ///< friction rows of contacts
    bool restitution;  ///< closing speeds of contacts
    bool continuous;   ///< the continuous stage
    bool rolling;      ///< rolling resistance of contacts
    bool locks;        ///< bodies locked in x or y

    friend constexpr bool operator==(const KernelSet&, const KernelSet&) = default;
};
/// "forces, friction, continuous": what is on; "none" for nothing.
SCREE_API std::string GetName(const KernelSet& kernels);
/// The smallest set that contains the features.
constexpr KernelSet ChooseKernels(Features f) {
    return {.bodyForces = f.Has(Feature::damping) || f.Has(Feature::gravityScale) || f.Has(Feature::forces),
            .speedLimit = f.Has(Feature::speedLimit),
            .friction = f.Has(Feature::friction),
            .restitution = f.Has(Feature::restitution),
            .continuous =
                f.Has(Feature::continuousStatic) || f.Has(Feature::continuousBullet) || f.Has(Feature::kinematicBodies),
            .rolling = f.Has(Feature::rollingResistance),
            .locks = f.Has(Feature::motionLocks)};
}

}  // namespace scree
