// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A listener and filter that edits the world from its callbacks.

#pragma once

#include "scree/scree.h"

namespace fuzz {

using namespace scree;

/// Hears of contacts and meddles with them and their bodies, by what the contacts are alone: worlds that are replayed
/// or loaded hear the same.
class Meddler final : public ContactListener, public ContactFilter {
public:
    void BeginContact(Contact* contact) override { React(*contact, 1); }
    void EndContact(Contact* contact) override { React(*contact, 2); }
    void PreSolve(Contact* contact, const Manifold*) override { React(*contact, 3); }
    void PostSolve(Contact* contact, const ContactImpulse*) override { React(*contact, 4); }
    bool ShouldCollide(Fixture* a, Fixture* b) override {
        return (a->GetIndex() + b->GetIndex()) % 7 != 0 && ContactFilter::ShouldCollide(a, b);
    }

private:
    static void React(Contact& contact, int call) {
        Fixture& fixture = *contact.GetFixtureA();
        Body& body = *(call % 2 == 0 ? fixture : *contact.GetFixtureB()).GetBody();
        const int kind = (7 * fixture.GetIndex() + 13 * contact.GetFixtureB()->GetIndex() + 29 * call) % 48;
        const auto amount = static_cast<float>(kind % 5);
        Manifold manifold = contact.GetManifold();
        switch (kind) {
            case 0:
                return static_cast<void>(contact.SetEnabled(false));
            case 1:
                return static_cast<void>(contact.SetFriction(amount));
            case 2:
                return static_cast<void>(contact.SetRestitution(amount));
            case 3:
                return static_cast<void>(contact.SetTangentSpeed(amount));
            case 4:
                manifold.pointCount = static_cast<int8_t>(manifold.pointCount / 2);
                manifold.localPoint.y += 0.125f;
                return static_cast<void>(contact.SetManifold(manifold));
            case 5:
                return static_cast<void>(body.SetLinearVelocity({amount, -amount}));
            case 6:
                return static_cast<void>(body.ApplyLinearImpulseToCenter({amount, amount}, true));
            case 7:
                return static_cast<void>(body.SetAwake(false));
            case 8:
                return static_cast<void>(body.SetType(kinematicBody));
            case 9:
                return static_cast<void>(body.SetEnabled(false));
            case 10:
                return static_cast<void>(body.SetTransform({amount, amount}, amount));
            case 11:
                return static_cast<void>(body.SetBullet(!body.IsBullet()));
            case 12:
                return static_cast<void>(body.SetFixedRotation(!body.IsFixedRotation()));
            case 13:
                return static_cast<void>(body.SetMotionLocks({true, false, false}));
            case 14:
                return static_cast<void>(body.SetGravityScale(amount));
            case 15:
                return static_cast<void>(fixture.SetSensor(!fixture.IsSensor()));
            case 16:
                return static_cast<void>(fixture.SetFilterData({3, 6, 0}));
            case 17:
                return static_cast<void>(fixture.Refilter());
            case 18:
                fixture.SetDensity(amount);
                return static_cast<void>(body.ResetMassData());
            case 19:
                return static_cast<void>(body.GetWorld()->DestroyBody(&body));
            case 20:
                return static_cast<void>(body.SetSleepingAllowed(false));
            case 21:
                return static_cast<void>(body.GetWorld()->SetGravity({amount, -10.0f}));
            case 22:
                return static_cast<void>(fixture.SetTangentSpeed(amount));
            case 23:
                return static_cast<void>(fixture.SetFriction(amount));
            default:
                return;
        }
    }
};

}  // namespace fuzz
