/* SPDX-FileCopyrightText: the Scree authors
 * SPDX-License-Identifier: MIT
 *
 * The engine for C and for languages that call C. Worlds are opaque; bodies, fixtures and joints are ids that tell when
 * their object is gone. Nothing calls back: events, transforms and velocities are read as arrays of the world itself,
 * without a copy. SI units, radians, y up.
 *
 * Bad input changes nothing: a call returns its error, or an id whose index is -1, and scree_last_error tells the field
 * and the cure. A world belongs to one thread at a time. If memory runs out, the program ends.
 */

#pragma once

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32) && defined(SCREE_SHARED) && defined(SCREE_EXPORTS)
#define SCREE_C_API __declspec(dllexport)
#elif defined(__GNUC__) && !defined(_WIN32)
#define SCREE_C_API __attribute__((visibility("default")))
#else
#define SCREE_C_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef struct scree_world scree_world;

/** Names of objects; an id whose index is -1 names nothing. */
typedef struct scree_body {
    int32_t index; /**< row of scree_transforms and scree_velocities */
    uint32_t generation;
} scree_body;
typedef struct scree_fixture {
    int32_t index;
    uint32_t generation;
} scree_fixture;
typedef struct scree_joint {
    int32_t index;
    uint32_t generation;
} scree_joint;

/** What bad input gets; as scree::ErrorCode. */
typedef enum scree_error {
    SCREE_OK,
    SCREE_NULL_ARGUMENT,
    SCREE_NON_FINITE,
    SCREE_OUT_OF_RANGE,
    SCREE_BAD_SHAPE,
    SCREE_FOREIGN_HANDLE, /**< the object is gone, or never was */
    SCREE_MISSING_FEATURE,
    SCREE_LOCKED
} scree_error;

/** The last call that a world refused. The texts live as long as the program. */
typedef struct scree_refusal {
    scree_error code; /**< SCREE_OK: there was none */
    const char* function;
    const char* field;
    const char* cure;
} scree_refusal;

typedef struct scree_vec2 {
    float x, y; /**< m, m/s, … */
} scree_vec2;

/** Where a body's origin is. */
typedef struct scree_transform {
    scree_vec2 position;
    float sin, cos; /**< of its angle */
} scree_transform;

/** Of a body's centre of mass. */
typedef struct scree_velocity {
    scree_vec2 linear;
    float angular;
    float unused;
} scree_velocity;

typedef enum scree_body_type { SCREE_STATIC, SCREE_KINEMATIC, SCREE_DYNAMIC } scree_body_type;

/** Begin with scree_default_world. */
typedef struct scree_world_def {
    scree_vec2 gravity;
    float length_scale;   /**< size of a typical body, m */
    int32_t worker_count; /**< threads that share a step; results do not depend on it */
    int32_t allow_sleep;
    int32_t continuous; /**< nothing passes through static fixtures between two steps */
} scree_world_def;

/** Begin with scree_default_body. */
typedef struct scree_body_def {
    int32_t type; /**< scree_body_type */
    scree_vec2 position;
    float angle;
    scree_vec2 linear_velocity;
    float angular_velocity;
    float linear_damping, angular_damping;
    float gravity_scale;
    int32_t fixed_rotation, bullet, allow_sleep;
} scree_body_def;

/** Begin with scree_default_fixture. */
typedef struct scree_fixture_def {
    uint64_t category_bits, mask_bits;
    float density; /**< kg/m² */
    float friction, restitution;
    int32_t is_sensor;
    int32_t group_index;
    uint8_t reports_contacts, reports_hits; /**< what scree_get_events tells of it */
} scree_fixture_def;

typedef enum scree_joint_type {
    SCREE_REVOLUTE,
    SCREE_PRISMATIC,
    SCREE_DISTANCE,
    SCREE_WELD,
    SCREE_WHEEL
} scree_joint_type;

/** Begin with scree_default_joint. */
typedef struct scree_joint_def {
    int32_t type; /**< scree_joint_type */
    scree_body body_a, body_b;
    scree_vec2 anchor_a; /**< world; the one anchor of all types but the distance joint */
    scree_vec2 anchor_b; /**< world; of the distance joint */
    scree_vec2 axis;     /**< world; of the prismatic and the wheel joint */
    int32_t collide_connected;
    int32_t enable_limit; /**< revolute, prismatic, wheel; of the distance joint: lower and upper count */
    float lower, upper;   /**< rad or m */
    int32_t enable_motor; /**< revolute, prismatic, wheel */
    float motor_speed;    /**< rad/s or m/s */
    float max_motor;      /**< N·m or N */
    float hertz;          /**< of the spring of a distance, weld or wheel joint; 0: none */
    float damping_ratio;
} scree_joint_def;

typedef struct scree_contact_event {
    scree_fixture a, b;
} scree_contact_event;
typedef struct scree_sensor_event {
    scree_fixture sensor, visitor;
} scree_sensor_event;
typedef struct scree_hit_event {
    scree_fixture a, b;
    scree_vec2 point, normal; /**< from a to b */
    float speed;              /**< m/s */
} scree_hit_event;

/** What happened in the last step. Valid until the next one. */
typedef struct scree_events {
    const scree_contact_event *begun, *ended;
    const scree_sensor_event *entered, *left;
    const scree_hit_event* hits;
    int32_t begun_count, ended_count, entered_count, left_count, hit_count;
} scree_events;

typedef struct scree_ray_hit {
    scree_fixture fixture; /**< index -1: nothing on the ray */
    scree_vec2 point, normal;
    float fraction;
} scree_ray_hit;

SCREE_C_API scree_world_def scree_default_world(void);
SCREE_C_API scree_body_def scree_default_body(void);
SCREE_C_API scree_fixture_def scree_default_fixture(void);
SCREE_C_API scree_joint_def scree_default_joint(void);

/** Null for settings that cannot be; `refusal` (may be null) then tells why. */
SCREE_C_API scree_world* scree_create_world(const scree_world_def* def, scree_refusal* refusal);
SCREE_C_API void scree_destroy_world(scree_world* world);
SCREE_C_API scree_refusal scree_last_error(const scree_world* world);

/** A step of sequential impulses, e.g. 8 and 3 iterations at 1/60 s. */
SCREE_C_API scree_error scree_step(scree_world* world, float time_step, int32_t velocity_iterations,
                                   int32_t position_iterations);
/** A step of `substeps` sub-steps with soft contacts, e.g. 4 at 1/60 s. */
SCREE_C_API scree_error scree_soft_step(scree_world* world, float time_step, int32_t substeps);

SCREE_C_API scree_body scree_create_body(scree_world* world, const scree_body_def* def);
SCREE_C_API scree_error scree_destroy_body(scree_world* world, scree_body body);
SCREE_C_API scree_error scree_set_transform(scree_world* world, scree_body body, scree_vec2 position, float angle);
SCREE_C_API scree_error scree_set_velocity(scree_world* world, scree_body body, scree_vec2 linear, float angular);
/** Of a force in newtons at a point of the world, until the end of the next step. Wakes the body. */
SCREE_C_API scree_error scree_apply_force(scree_world* world, scree_body body, scree_vec2 force, scree_vec2 point);
SCREE_C_API scree_error scree_apply_impulse(scree_world* world, scree_body body, scree_vec2 impulse, scree_vec2 point);
/** 1 or 0; 0 for a body that is gone. */
SCREE_C_API int32_t scree_is_awake(const scree_world* world, scree_body body);
/** kg; 0 for a body that is gone. */
SCREE_C_API float scree_get_mass(const scree_world* world, scree_body body);

/** Points are in the body's coordinates. */
SCREE_C_API scree_fixture scree_add_circle(scree_world* world, scree_body body, const scree_fixture_def* def,
                                           scree_vec2 centre, float radius);
SCREE_C_API scree_fixture scree_add_box(scree_world* world, scree_body body, const scree_fixture_def* def,
                                        scree_vec2 half_extents, scree_vec2 centre, float angle);
/** The convex hull of 3 to 8 points. */
SCREE_C_API scree_fixture scree_add_polygon(scree_world* world, scree_body body, const scree_fixture_def* def,
                                            const scree_vec2* points, int32_t count);
SCREE_C_API scree_fixture scree_add_capsule(scree_world* world, scree_body body, const scree_fixture_def* def,
                                            scree_vec2 from, scree_vec2 to, float radius);
SCREE_C_API scree_fixture scree_add_edge(scree_world* world, scree_body body, const scree_fixture_def* def,
                                         scree_vec2 from, scree_vec2 to);
/** A closed chain of one-sided edges through at least 3 points: counter-clockwise ones collide outside. The first edge;
 * the ids of the others follow where no fixture was destroyed before. */
SCREE_C_API scree_fixture scree_add_loop(scree_world* world, scree_body body, const scree_fixture_def* def,
                                         const scree_vec2* points, int32_t count);
SCREE_C_API scree_error scree_destroy_fixture(scree_world* world, scree_fixture fixture);
/** The body of a fixture. */
SCREE_C_API scree_body scree_get_body(const scree_world* world, scree_fixture fixture);

SCREE_C_API scree_joint scree_create_joint(scree_world* world, const scree_joint_def* def);
SCREE_C_API scree_error scree_destroy_joint(scree_world* world, scree_joint joint);

/** The world's own rows, by scree_body::index; `count` (may be null) gets their number. Rows of bodies that are gone
 * hold left-overs. Valid until a body is created or the world destroyed; every step writes them anew. O(1). */
SCREE_C_API const scree_transform* scree_transforms(const scree_world* world, size_t* count);
SCREE_C_API const scree_velocity* scree_velocities(const scree_world* world, size_t* count);
SCREE_C_API scree_events scree_get_events(const scree_world* world);
/** The first fixture on the way from one point to another. */
SCREE_C_API scree_ray_hit scree_cast_ray(const scree_world* world, scree_vec2 from, scree_vec2 to);

/** Equal hashes mean equal futures. */
SCREE_C_API uint64_t scree_state_hash(const scree_world* world);
/** The bytes of the world's image. They are written to `buffer` if `capacity` suffices. */
SCREE_C_API size_t scree_save_world(const scree_world* world, void* buffer, size_t capacity);
/** Null for bytes that are no image of this version of the library. */
SCREE_C_API scree_world* scree_load_world(const void* image, size_t size);

#ifdef __cplusplus
}
#endif
