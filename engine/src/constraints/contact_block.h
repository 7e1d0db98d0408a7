// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Eight contacts side by side, as the vector kernels read them: one array of eight numbers per quantity. No two
// contacts of a block push the same body. Plain data only, because translation units for different instruction sets
// share it.
//
// Side B of every lane is a dynamic body. Side A is one too in two-mover blocks. Else it is a body that contacts cannot
// push (static, kinematic), which is read and never written. Lanes to spare repeat the bodies of the first lane with no
// mass: they change nothing, and the first lane is written last.

#pragma once

#include <cstdint>

namespace scree {

inline constexpr int blockLanes = 8;

/// Above this condition number of the 2×2 effective mass the two points of a contact are as good as one, and solving
/// them together would lose digits: one is solved.
inline constexpr float maxConditionNumber = 1000.0f;

struct alignas(32) ContactBlock {
    using Row = float[blockLanes];

    int32_t bodyA[blockLanes], bodyB[blockLanes];
    int32_t slot[blockLanes];  ///< position in the solver's list of contacts, −1 for a lane to spare
    Row invMassA, invMassB, invIA, invIB;
    Row normalX, normalY;                  ///< from A to B
    Row armA[2], armB[2];                  ///< per point: arm × normal
    Row tangentArmA, tangentArmB;          ///< arm of the middle of the points × tangent
    Row normalMass[2], tangentMass;        ///< effective, kg
    Row coupling;                          ///< speed of one point by a unit of impulse at the other, 1/kg
    Row separation[2];                     ///< at the start of the step, + the overlap to leave, m
    Row initialOverlap[2];                 ///< soft step: initial overlap that separation leaves out, m
    Row normalImpulse[2], tangentImpulse;  ///< accumulated, N·s
    Row friction, tangentSpeed;
    Row restitution, restitutionThreshold;  ///< the latter in m/s
    /// Speed that the normal row asks for, m/s: restitution (sequential impulses), or how fast the gap may still close
    /// (soft step).
    Row bias[2];
    Row totalNormal[2], totalTangent;  ///< soft step: sums over the sub-steps, N·s
};

// A manifold as floats (scree/collision.h): two points of five (x, y, normal impulse, tangent impulse, id), then the
// local normal and the local point. One more has its type and number of points.
inline constexpr int manifoldFloats = 15, manifoldPointFloats = 5, manifoldNormalAt = 10;

// A steady contact (state/contacts.h) as floats. First come turns of A and B and the way between the centres, then
// normal, whether it is kept, and reach. Then come arms of both points, separations, whether its sides are swapped, and
// the overlap that it began with.
inline constexpr int steadyFloats = 16, steadyInitialAt = 15;

/// Where filling finds what it needs: columns of the tables of bodies and contacts, rows of floats.
struct FillSource {
    const float* transform;     ///< by body: x, y, sine, cosine of the origin
    const float* position;      ///< by body: x, y of the centre of mass, and two more
    const float* velocity;      ///< by body: x, y, angular, and one more
    const float* mass;          ///< by body: inverse mass, inverse inertia, and two more
    const float* manifold;      ///< by contact: Manifold
    const float* material;      ///< by contact: friction, restitution, restitution threshold, tangent speed
    float impulseScale;         ///< of warm starting
    float slop;                 ///< overlap to leave, m
    bool restitution;           ///< some contact may bounce
    bool onMoverSurface;        ///< where friction with the unmovable acts (BlockInput)
    float* steady = nullptr;    ///< by contact: SteadyContact; null: every contact is as its manifold says
    float leastInitial = 0.0f;  ///< smaller initial overlap is left to springs, m
};

/// What filling is told of the contacts of one block; its bodies and slots are set.
struct alignas(32) FillLanes {
    using Row = float[blockLanes];
    int32_t contact[blockLanes];
    Row referenceIsB;      ///< 1: the manifold's face, or its first circle, is on side B; else 0
    Row isCircles;         ///< 1 or 0
    Row isSwapped;         ///< 1: side A is the contact's B; else 0
    Row radiusA, radiusB;  ///< of the shapes of side A and B, m
    int32_t count;         ///< lanes in use; the others repeat the first
    bool anyCircles;
    bool areKept;  ///< all have steady rows, which are all that is asked for of the rest
    bool isFar;    ///< in frames near the contacts, below, instead of FillSource's transforms and positions
    float transformA[blockLanes][4], transformB[blockLanes][4];
    float positionA[blockLanes][4], positionB[blockLanes][4];
};

/// What a run of blocks has in common.
struct BlockKind {
    bool fixedA;
    bool twoPoints;
};

/// Blocks of one colour and kind, which follow each other: no two of a colour share a moving body.
struct BlockRange {
    int32_t begin, end;
    BlockKind kind;
    int32_t colour;
};

/// A contact as an implicit spring over one sub-step (Catto, "Soft Constraints: Reinventing the Spring", GDC 2011).
struct SoftSpring {
    float biasRate;   ///< 1/s
    float stiffness;  ///< inverse mass of the row over that of a rigid one
};

/// Constants of the soft contact rows.
struct SoftConstants {
    float inverseH;             ///< of a sub-step, 1/s
    float pushSpeed;            ///< largest speed of pushing apart, m/s
    SoftSpring between, fixed;  ///< two movers; a mover and what cannot be pushed
};

/// What the kernels work on. `velocity` and `delta` hold four floats a body: v and w, or the motion since the start of
/// the step; the fourth is unused.
struct KernelTask {
    ContactBlock* blocks;
    const BlockRange* ranges;
    int32_t rangeCount;
    const class BlockChains* chains;  ///< how threads share the blocks; null: colour by colour
    float* velocity;
    float* delta;
    SoftConstants soft;
    bool sumImpulses;          ///< keep totalNormal and totalTangent
    bool friction;             ///< false: no contact has friction, and all tangent impulses are 0
    float leastBounce = 0.0f;  ///< of bounce: contacts whose restitution is no larger take no part
    float largestPush = 0.2f;  ///< of pushApart in one pass: maxLinearCorrection, m
};

/// What filling has found among the contacts of a block.
struct FillFindings {
    bool bounces = false;     ///< some contact may
    int initialOverlaps = 0;  ///< contacts with some
};

/// How far overlap in which bodies were made is parted in a step.
struct Parting {
    float share, largestShare;  ///< of the overlap; of what is so small or so deep that it parts as fast as it can
    float atOnce, deep;         ///< m: small is what is below, deep what is above
    float most;                 ///< m
};

/// The kernels for one instruction set. All sets give the same bits.
struct ContactKernels {
    const char* name;
    /// Everything but bodies and slots, of a block of this kind.
    FillFindings (*fill)(const FillSource& source, const FillLanes& lanes, BlockKind kind, ContactBlock& block);
    void (*warmStart)(const KernelTask& task);
    /// Sequential impulses: one iteration on velocities.
    void (*solveRigid)(const KernelTask& task);
    /// One pass over overlaps: moves `delta` by `share` of what is left of them and returns the smallest separation, m.
    float (*pushApart)(const KernelTask& task, float share);
    /// Soft step: one iteration with soft rows, then, after positions have moved, one without push.
    void (*solveSoft)(const KernelTask& task);
    void (*relax)(const KernelTask& task);
    /// Soft step, at the start of a sub-step: contacts that are met in it leave with their share of the speed at which
    /// they close. They have friction up to that of the blow. One pass; true if there are any.
    bool (*bounce)(const KernelTask& task);
    /// Soft step, before the first sub-step: one pass that moves `delta` apart where contacts began with overlap, by no
    /// more than the gap where there is one. Returns how much was lacking at the worst point, m. Then what is left of
    /// these overlaps; below `least` nothing is.
    float (*part)(const KernelTask& task, const Parting& parting);
    void (*endParting)(const KernelTask& task, const Parting& parting, float least);
};

/// The best set this processor has.
const ContactKernels& GetContactKernels();

}  // namespace scree
