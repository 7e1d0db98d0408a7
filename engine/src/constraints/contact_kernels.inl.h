// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The vector kernels of the contact solver, compiled once per instruction set: the including file names the set by
// SCREE_KERNEL_SET and is compiled with its flags. Nothing here but plain arithmetic on contact_block.h.
//
// Rows: a friction row through the middle of the points, then one normal row a point (soft step), or both points as one
// block (sequential impulses; the linear complementarity problem by enumeration of its four cases). Separations are
// linear in the motion since the start of the step, with the Jacobians frozen there (Macklin et al., "Small Steps in
// Physics Simulation", 2019; Catto, "Solver2D", 2024).

#pragma once

#include "base/wide.h"
#include "constraints/contact_block.h"

namespace scree {

namespace {

struct Motion8 {
    F8 x, y, w;
};

/// A block's constant side, in registers.
template <bool fixedA>
struct Rows {
    F8 nx, ny;
    F8 imB, iB;
    F8 imA, iA;
};

template <bool fixedA>
SCREE_KERNEL Rows<fixedA> LoadRows(const ContactBlock& b) {
    Rows<fixedA> r;
    r.nx = Load8(b.normalX), r.ny = Load8(b.normalY);
    r.imB = Load8(b.invMassB), r.iB = Load8(b.invIB);
    if constexpr (!fixedA) r.imA = Load8(b.invMassA), r.iA = Load8(b.invIA);
    return r;
}

SCREE_KERNEL Motion8 LoadBodies(const float* column, const int32_t* index) {
    Motion8 m;
    Gather8(column, index, m.x, m.y, m.w);
    return m;
}

SCREE_KERNEL F8 NormalSpeed(F8 nx, F8 ny, F8 armA, F8 armB, const Motion8& a, const Motion8& b) {
    return nx * (b.x - a.x) + ny * (b.y - a.y) + (armB * b.w - armA * a.w);
}
/// The tangent is the normal turned clockwise: (ny, −nx).
SCREE_KERNEL F8 TangentSpeed(F8 nx, F8 ny, F8 armA, F8 armB, const Motion8& a, const Motion8& b) {
    return ny * (b.x - a.x) - nx * (b.y - a.y) + (armB * b.w - armA * a.w);
}

template <bool fixedA>
SCREE_KERNEL void PushNormal(const Rows<fixedA>& r, F8 armA, F8 armB, F8 impulse, Motion8& a, Motion8& b) {
    const F8 px = impulse * r.nx, py = impulse * r.ny;
    if constexpr (!fixedA) {
        a.x = a.x - r.imA * px, a.y = a.y - r.imA * py;
        a.w = a.w - r.iA * (armA * impulse);
    }
    b.x = b.x + r.imB * px, b.y = b.y + r.imB * py;
    b.w = b.w + r.iB * (armB * impulse);
}
template <bool fixedA>
SCREE_KERNEL void PushTangent(const Rows<fixedA>& r, F8 armA, F8 armB, F8 impulse, Motion8& a, Motion8& b) {
    const F8 px = impulse * r.ny, py = impulse * r.nx;
    if constexpr (!fixedA) {
        a.x = a.x - r.imA * px, a.y = a.y + r.imA * py;
        a.w = a.w - r.iA * (armA * impulse);
    }
    b.x = b.x + r.imB * px, b.y = b.y - r.imB * py;
    b.w = b.w + r.iB * (armB * impulse);
}

template <bool fixedA>
SCREE_KERNEL void StoreBodies(float* column, const ContactBlock& block, const Motion8& a, const Motion8& b) {
    if constexpr (!fixedA) Scatter8(column, block.bodyA, a.x, a.y, a.w);
    Scatter8(column, block.bodyB, b.x, b.y, b.w);
}

template <bool fixedA, int points>
SCREE_KERNEL void SolveFriction(ContactBlock& block, const Rows<fixedA>& r, Motion8& a, Motion8& b) {
    const F8 armA = Load8(block.tangentArmA), armB = Load8(block.tangentArmB);
    const F8 old = Load8(block.tangentImpulse);
    F8 pressure = Load8(block.normalImpulse[0]);
    if constexpr (points == 2) pressure = pressure + Load8(block.normalImpulse[1]);
    const F8 limit = Load8(block.friction) * pressure;
    const F8 speed = TangentSpeed(r.nx, r.ny, armA, armB, a, b) - Load8(block.tangentSpeed);
    const F8 wanted = old - Load8(block.tangentMass) * speed;
    const F8 total = Max8(Splat8(0.0f) - limit, Min8(wanted, limit));
    Store8(block.tangentImpulse, total);
    PushTangent(r, armA, armB, total - old, a, b);
}

/// Calls kernel<fixedA, points>(block) for all blocks, range by range.
template <typename Kernel>
SCREE_KERNEL void ForEachBlock(const KernelTask& task, Kernel&& kernel) {
    for (int32_t i = 0; i < task.rangeCount; ++i) {
        const BlockRange range = task.ranges[i];
        ContactBlock* const begin = task.blocks + range.begin;
        ContactBlock* const end = task.blocks + range.end;
        if (range.kind.fixedA) {
            if (range.kind.twoPoints) {
                for (ContactBlock* b = begin; b != end; ++b) kernel.template Run<true, 2>(*b);
            } else {
                for (ContactBlock* b = begin; b != end; ++b) kernel.template Run<true, 1>(*b);
            }
        } else if (range.kind.twoPoints) {
            for (ContactBlock* b = begin; b != end; ++b) kernel.template Run<false, 2>(*b);
        } else {
            for (ContactBlock* b = begin; b != end; ++b) kernel.template Run<false, 1>(*b);
        }
    }
}

SCREE_KERNEL F8 InverseOrZero8(F8 k) {
    const F8 zero = Splat8(0.0f);
    const F8 positive = Greater8(k, zero);
    return And8(positive, Splat8(1.0f)) / Select8(positive, k, Splat8(1.0f));
}

struct FinishKernel {
    template <bool fixedA, int points>
    SCREE_KERNEL F8 InverseMass(const Rows<fixedA>& r, F8 armA, F8 armB) {
        F8 k = r.imB + r.iB * armB * armB;
        if constexpr (!fixedA) k = k + r.imA + r.iA * armA * armA;
        return k;
    }
    template <bool fixedA, int points>
    [[gnu::always_inline]] inline void Run(ContactBlock& block) const {
        const Rows<fixedA> r = LoadRows<fixedA>(block);
        for (int p = 0; p < points; ++p) {
            const F8 k = InverseMass<fixedA, points>(r, Load8(block.armA[p]), Load8(block.armB[p]));
            Store8(block.normalMass[p], InverseOrZero8(k));
        }
        const F8 k = InverseMass<fixedA, points>(r, Load8(block.tangentArmA), Load8(block.tangentArmB));
        Store8(block.tangentMass, InverseOrZero8(k));
    }
};

struct WarmStartKernel {
    const KernelTask& task;
    template <bool fixedA, int points>
    [[gnu::always_inline]] inline void Run(ContactBlock& block) const {
        const Rows<fixedA> r = LoadRows<fixedA>(block);
        Motion8 a{}, b = LoadBodies(task.velocity, block.bodyB);
        if constexpr (!fixedA) a = LoadBodies(task.velocity, block.bodyA);
        for (int p = 0; p < points; ++p)
            PushNormal(r, Load8(block.armA[p]), Load8(block.armB[p]), Load8(block.normalImpulse[p]), a, b);
        PushTangent(r, Load8(block.tangentArmA), Load8(block.tangentArmB), Load8(block.tangentImpulse), a, b);
        StoreBodies<fixedA>(task.velocity, block, a, b);
    }
};

struct RigidKernel {
    const KernelTask& task;

    template <bool fixedA>
    SCREE_KERNEL void SolvePoint(ContactBlock& block, const Rows<fixedA>& r, Motion8& a, Motion8& b) {
        const F8 armA = Load8(block.armA[0]), armB = Load8(block.armB[0]);
        const F8 old = Load8(block.normalImpulse[0]);
        const F8 speed = NormalSpeed(r.nx, r.ny, armA, armB, a, b) - Load8(block.bias[0]);
        const F8 total = Max8(old - Load8(block.normalMass[0]) * speed, Splat8(0.0f));
        Store8(block.normalImpulse[0], total);
        PushNormal(r, armA, armB, total - old, a, b);
    }

    /// The total impulses x ≥ 0 with speeds K·x + q ≥ 0 and x·(K·x + q) = 0: both points push, only the first, only the
    /// second, or none. Where none of these holds (rounding) the impulses stay. Where the points are so close together
    /// that K is ill-conditioned, the first point stands for both.
    template <bool fixedA>
    SCREE_KERNEL void SolvePair(ContactBlock& block, const Rows<fixedA>& r, Motion8& a, Motion8& b) {
        const F8 zero = Splat8(0.0f);
        const F8 a1 = Load8(block.armA[0]), a2 = Load8(block.armA[1]);
        const F8 b1 = Load8(block.armB[0]), b2 = Load8(block.armB[1]);
        F8 mass = r.imB, k11 = r.iB * b1 * b1, k12 = r.iB * b1 * b2, k22 = r.iB * b2 * b2;
        if constexpr (!fixedA) {
            mass = mass + r.imA;
            k11 = k11 + r.iA * a1 * a1, k12 = k12 + r.iA * a1 * a2, k22 = k22 + r.iA * a2 * a2;
        }
        k11 = k11 + mass, k12 = k12 + mass, k22 = k22 + mass;
        const F8 det = k11 * k22 - k12 * k12;
        constexpr float maxConditionNumber = 1000.0f;  // above it the block solve would lose digits
        const F8 good = Greater8(Splat8(maxConditionNumber) * det, k11 * k11);
        const F8 inverse = Splat8(1.0f) / Select8(good, det, Splat8(1.0f));

        const F8 old1 = Load8(block.normalImpulse[0]), old2 = Load8(block.normalImpulse[1]);
        const F8 q1 = NormalSpeed(r.nx, r.ny, a1, b1, a, b) - Load8(block.bias[0]) - (k11 * old1 + k12 * old2);
        const F8 q2 = NormalSpeed(r.nx, r.ny, a2, b2, a, b) - Load8(block.bias[1]) - (k12 * old1 + k22 * old2);
        const F8 both1 = (k12 * q2 - k22 * q1) * inverse, both2 = (k12 * q1 - k11 * q2) * inverse;
        const F8 first = zero - Load8(block.normalMass[0]) * q1, second = zero - Load8(block.normalMass[1]) * q2;

        const F8 none = And8(GreaterEqual8(q1, zero), GreaterEqual8(q2, zero));
        const F8 onlySecond = And8(good, And8(GreaterEqual8(second, zero), GreaterEqual8(k12 * second + q1, zero)));
        const F8 notGood = Select8(good, zero, GreaterEqual8(zero, zero));
        const F8 onlyFirst = And8(GreaterEqual8(first, zero), Or8(notGood, GreaterEqual8(k12 * first + q2, zero)));
        const F8 isBoth = And8(good, And8(GreaterEqual8(both1, zero), GreaterEqual8(both2, zero)));
        F8 x1 = Select8(none, zero, old1), x2 = Select8(none, zero, old2);
        x1 = Select8(onlySecond, zero, x1), x2 = Select8(onlySecond, second, x2);
        x1 = Select8(onlyFirst, first, x1), x2 = Select8(onlyFirst, zero, x2);
        x1 = Select8(isBoth, both1, x1), x2 = Select8(isBoth, both2, x2);
        Store8(block.normalImpulse[0], x1);
        Store8(block.normalImpulse[1], x2);
        PushNormal(r, a1, b1, x1 - old1, a, b);
        PushNormal(r, a2, b2, x2 - old2, a, b);
    }

    template <bool fixedA, int points>
    [[gnu::always_inline]] inline void Run(ContactBlock& block) const {
        const Rows<fixedA> r = LoadRows<fixedA>(block);
        Motion8 a = LoadBodies(task.velocity, block.bodyA), b = LoadBodies(task.velocity, block.bodyB);
        SolveFriction<fixedA, points>(block, r, a, b);
        if constexpr (points == 2) {
            SolvePair<fixedA>(block, r, a, b);
        } else {
            SolvePoint<fixedA>(block, r, a, b);
        }
        StoreBodies<fixedA>(task.velocity, block, a, b);
    }
};

struct PushApartKernel {
    const KernelTask& task;
    float share;
    mutable F8 smallest;

    template <bool fixedA, int points>
    [[gnu::always_inline]] inline void Run(ContactBlock& block) const {
        constexpr float largestPush = 0.2f;  // maxLinearCorrection, m
        const Rows<fixedA> r = LoadRows<fixedA>(block);
        Motion8 a = LoadBodies(task.delta, block.bodyA), b = LoadBodies(task.delta, block.bodyB);
        for (int p = 0; p < points; ++p) {
            const F8 armA = Load8(block.armA[p]), armB = Load8(block.armB[p]);
            const F8 s = Load8(block.separation[p]) + NormalSpeed(r.nx, r.ny, armA, armB, a, b);
            smallest = Min8(smallest, s);
            const F8 push = Max8(Splat8(-largestPush), Min8(Splat8(share) * s, Splat8(0.0f)));
            PushNormal(r, armA, armB, Splat8(0.0f) - Load8(block.normalMass[p]) * push, a, b);
        }
        StoreBodies<fixedA>(task.delta, block, a, b);
    }
};

struct SoftKernel {
    const KernelTask& task;
    template <bool fixedA, int points>
    [[gnu::always_inline]] inline void Run(ContactBlock& block) const {
        const Rows<fixedA> r = LoadRows<fixedA>(block);
        Motion8 a = LoadBodies(task.velocity, block.bodyA), b = LoadBodies(task.velocity, block.bodyB);
        F8 gap[points];
        {
            const Motion8 dA = LoadBodies(task.delta, block.bodyA), dB = LoadBodies(task.delta, block.bodyB);
            for (int p = 0; p < points; ++p) {
                gap[p] = Load8(block.separation[p]) +
                         NormalSpeed(r.nx, r.ny, Load8(block.armA[p]), Load8(block.armB[p]), dA, dB);
            }
        }
        SolveFriction<fixedA, points>(block, r, a, b);
        const F8 zero = Splat8(0.0f), one = Splat8(1.0f);
        for (int p = 0; p < points; ++p) {
            const F8 armA = Load8(block.armA[p]), armB = Load8(block.armB[p]);
            const F8 old = Load8(block.normalImpulse[p]);
            const F8 open = Greater8(gap[p], zero);  // may close, but not further, within this sub-step
            const F8 allowed = gap[p] * Splat8(task.soft.inverseH);
            const F8 pushing = Max8(gap[p] * Splat8(task.soft.biasRate), Splat8(-task.soft.pushSpeed));
            const F8 bias = Select8(open, allowed, pushing);
            const F8 massScale = Select8(open, one, Splat8(task.soft.massScale));
            const F8 impulseScale = Select8(open, zero, Splat8(task.soft.impulseScale));
            Store8(block.bias[p], Max8(allowed, zero));
            const F8 speed = NormalSpeed(r.nx, r.ny, armA, armB, a, b) + bias;
            const F8 change = Load8(block.normalMass[p]) * massScale * speed + impulseScale * old;
            const F8 total = Max8(old - change, zero);
            Store8(block.normalImpulse[p], total);
            PushNormal(r, armA, armB, total - old, a, b);
        }
        StoreBodies<fixedA>(task.velocity, block, a, b);
    }
};

struct RelaxKernel {
    const KernelTask& task;
    template <bool fixedA, int points>
    [[gnu::always_inline]] inline void Run(ContactBlock& block) const {
        const Rows<fixedA> r = LoadRows<fixedA>(block);
        Motion8 a = LoadBodies(task.velocity, block.bodyA), b = LoadBodies(task.velocity, block.bodyB);
        SolveFriction<fixedA, points>(block, r, a, b);
        for (int p = 0; p < points; ++p) {
            const F8 armA = Load8(block.armA[p]), armB = Load8(block.armB[p]);
            const F8 old = Load8(block.normalImpulse[p]);
            const F8 speed = NormalSpeed(r.nx, r.ny, armA, armB, a, b) + Load8(block.bias[p]);
            const F8 total = Max8(old - Load8(block.normalMass[p]) * speed, Splat8(0.0f));
            Store8(block.normalImpulse[p], total);
            PushNormal(r, armA, armB, total - old, a, b);
            if (task.sumImpulses) Store8(block.totalNormal[p], Load8(block.totalNormal[p]) + total);
        }
        if (task.sumImpulses) Store8(block.totalTangent, Load8(block.totalTangent) + Load8(block.tangentImpulse));
        StoreBodies<fixedA>(task.velocity, block, a, b);
    }
};

struct BounceKernel {
    const KernelTask& task;
    template <bool fixedA, int points>
    [[gnu::always_inline]] inline void Run(ContactBlock& block) const {
        const F8 zero = Splat8(0.0f);
        F8 any = zero;
        for (int p = 0; p < points; ++p) any = Or8(any, Greater8(Load8(block.bounceSpeed[p]), zero));
        if (!AnySet8(any)) return;
        const Rows<fixedA> r = LoadRows<fixedA>(block);
        Motion8 a = LoadBodies(task.velocity, block.bodyA), b = LoadBodies(task.velocity, block.bodyB);
        for (int p = 0; p < points; ++p) {
            const F8 armA = Load8(block.armA[p]), armB = Load8(block.armB[p]);
            const F8 old = Load8(block.normalImpulse[p]), leave = Load8(block.bounceSpeed[p]);
            const F8 bounces = And8(Greater8(leave, zero), Greater8(Load8(block.totalNormal[p]), zero));
            const F8 speed = NormalSpeed(r.nx, r.ny, armA, armB, a, b) - leave;
            const F8 total = Select8(bounces, Max8(old - Load8(block.normalMass[p]) * speed, zero), old);
            Store8(block.normalImpulse[p], total);
            Store8(block.totalNormal[p], Load8(block.totalNormal[p]) + (total - old));
            PushNormal(r, armA, armB, total - old, a, b);
        }
        StoreBodies<fixedA>(task.velocity, block, a, b);
    }
};

void Finish(const KernelTask& task) { ForEachBlock(task, FinishKernel{}); }
void WarmStart(const KernelTask& task) { ForEachBlock(task, WarmStartKernel{task}); }
void SolveRigid(const KernelTask& task) { ForEachBlock(task, RigidKernel{task}); }
float PushApart(const KernelTask& task, float share) {
    const PushApartKernel kernel{task, share, Splat8(1.0f)};
    ForEachBlock(task, kernel);
    alignas(32) float lanes[laneCount];
    Store8(lanes, kernel.smallest);
    float smallest = lanes[0];
    for (const float s : lanes) smallest = s < smallest ? s : smallest;
    return smallest;
}
void SolveSoft(const KernelTask& task) { ForEachBlock(task, SoftKernel{task}); }
void Relax(const KernelTask& task) { ForEachBlock(task, RelaxKernel{task}); }
void Bounce(const KernelTask& task) { ForEachBlock(task, BounceKernel{task}); }

}  // namespace

/// The table of this instruction set.
extern const ContactKernels SCREE_KERNEL_SET;
const ContactKernels SCREE_KERNEL_SET = {SCREE_KERNEL_NAME, &Finish,    &WarmStart, &SolveRigid,
                                         &PushApart,        &SolveSoft, &Relax,     &Bounce};

}  // namespace scree
