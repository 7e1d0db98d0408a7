// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Rules of mixing.

#include "pipeline/parts/mix_materials.h"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

/// `standard()` gives what the standard rule makes of both, `ask()` what the program does.
template <typename Standard, typename Ask>
float Mix(MixRule rule, float a, float b, Standard&& standard, Ask&& ask) {
    switch (rule) {
        case MixRule::average:
            return 0.5f * a + 0.5f * b;
        case MixRule::minimum:
            return Min(a, b);
        case MixRule::multiply: {
            const float product = a * b;
            return std::isfinite(product) ? product : standard();
        }
        case MixRule::maximum:
            return Max(a, b);
        case MixRule::custom:
            return ask();
        default:
            return standard();
    }
}

}  // namespace

ContactMaterial MixMaterials(FixtureIndex fixtureA, FixtureIndex fixtureB, const FixtureTable& fixtures,
                             MaterialMixer* mixer) {
    const Material& a = fixtures.material[fixtureA];
    const Material& b = fixtures.material[fixtureB];
    const Fixture* const handleA = &fixtures.handles[fixtureA];
    const Fixture* const handleB = &fixtures.handles[fixtureB];
    const auto friction = [&] { return MixFriction(a.friction, b.friction); };
    const auto restitution = [&] { return MixRestitution(a.restitution, b.restitution); };
    ContactMaterial mixed;
    mixed.friction = Mix(std::max(a.frictionRule, b.frictionRule), a.friction, b.friction, friction, [&] {
        const float own = mixer != nullptr ? mixer->MixFriction(handleA, handleB) : -1.0f;
        return std::isfinite(own) && own >= 0.0f ? own : friction();
    });
    mixed.restitution =
        Mix(std::max(a.restitutionRule, b.restitutionRule), a.restitution, b.restitution, restitution, [&] {
            if (mixer == nullptr) return restitution();
            const float own = mixer->MixRestitution(handleA, handleB);
            return std::isfinite(own) ? own : restitution();
        });
    mixed.restitutionThreshold = MixRestitutionThreshold(a.restitutionThreshold, b.restitutionThreshold);
    mixed.tangentSpeed = a.tangentSpeed + b.tangentSpeed;
    return mixed;
}

}  // namespace scree
