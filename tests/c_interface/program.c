/* SPDX-FileCopyrightText: the Scree authors
 * SPDX-License-Identifier: MIT
 *
 * The interface for C, from C. A pile falls, events and rows are read as arrays, and ids outlive their objects. Bad
 * input is told and changes nothing. An image goes on as the world would have.
 */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scree/scree_c.h"

static int failures = 0;

#define CHECK(condition)                                          \
    do {                                                          \
        if (!(condition)) {                                       \
            ++failures;                                           \
            printf("line %d: not so: %s\n", __LINE__, #condition); \
        }                                                         \
    } while (0)

enum { boxCount = 40 };

/* Boxes above a floor; those with an even number report contacts and blows. */
static scree_world* make_pile(scree_body* boxes) {
    scree_world* world = scree_create_world(NULL, NULL);
    const scree_body floor = scree_create_body(world, NULL);
    const scree_vec2 left = {-20.0f, 0.0f}, right = {20.0f, 0.0f}, half = {0.5f, 0.5f}, centre = {0.0f, 0.0f};
    CHECK(scree_add_edge(world, floor, NULL, left, right).index >= 0);
    for (int i = 0; i < boxCount; ++i) {
        scree_body_def body = scree_default_body();
        scree_fixture_def fixture = scree_default_fixture();
        body.type = SCREE_DYNAMIC;
        body.position.x = 1.2f * (float)(i % 8);
        body.position.y = 1.0f + 1.5f * (float)(i / 8);
        boxes[i] = scree_create_body(world, &body);
        fixture.density = 1.0f;
        fixture.reports_contacts = fixture.reports_hits = (uint8_t)(i % 2 == 0);
        CHECK(scree_add_box(world, boxes[i], &fixture, half, centre, 0.0f).index >= 0);
        CHECK(fabsf(scree_get_mass(world, boxes[i]) - 1.0f) < 1e-5f);
    }
    return world;
}

static void check_rows_and_events(void) {
    scree_body boxes[boxCount];
    scree_world* world = make_pile(boxes);
    const uint64_t before = scree_state_hash(world);
    size_t rows = 0;
    const scree_transform* transforms = scree_transforms(world, &rows);
    const scree_velocity* velocities = scree_velocities(world, NULL);
    int begun = 0, hits = 0;
    CHECK(rows == boxCount + 1);
    for (int step = 0; step < 200; ++step) {
        scree_events events;
        CHECK(scree_soft_step(world, 1.0f / 60.0f, 4) == SCREE_OK);
        events = scree_get_events(world);
        begun += events.begun_count;
        hits += events.hit_count;
        for (int32_t i = 0; i < events.hit_count; ++i) {
            const scree_hit_event* hit = &events.hits[i];
            CHECK(hit->speed >= 1.0f && scree_get_body(world, hit->a).index >= 0);
        }
    }
    CHECK(scree_state_hash(world) != before);
    CHECK(begun >= boxCount / 2 && hits > 0);
    CHECK(transforms == scree_transforms(world, NULL)); /* the same rows, written anew */
    for (int i = 0; i < boxCount; ++i) {
        const scree_transform* t = &transforms[boxes[i].index];
        CHECK(t->position.y > 0.4f && t->position.y < 10.0f);
        CHECK(fabsf(t->sin * t->sin + t->cos * t->cos - 1.0f) < 1e-5f);
        CHECK(fabsf(velocities[boxes[i].index].linear.y) < 1.0f);
    }
    {
        const scree_vec2 from = {transforms[boxes[0].index].position.x, 50.0f};
        const scree_vec2 to = {from.x, -50.0f};
        const scree_ray_hit hit = scree_cast_ray(world, from, to);
        CHECK(hit.fixture.index >= 0 && hit.normal.y > 0.5f);
    }
    scree_destroy_world(world);
}

static void check_ids_and_errors(void) {
    scree_body boxes[boxCount];
    scree_world* world = make_pile(boxes);
    const uint64_t before = scree_state_hash(world);
    const scree_vec2 zero = {0.0f, 0.0f}, bad = {NAN, 0.0f};
    const scree_vec2 line[3] = {{0.0f, 0.0f}, {1.0f, 0.0f}, {2.0f, 0.0f}};
    scree_body_def body = scree_default_body();
    scree_joint_def joint = scree_default_joint();
    scree_world_def settings = scree_default_world();
    scree_refusal why;

    CHECK(scree_last_error(world).code == SCREE_OK);
    CHECK(scree_set_velocity(world, boxes[0], bad, 1.0f) == SCREE_NON_FINITE);
    CHECK(scree_set_velocity(world, boxes[0], zero, NAN) == SCREE_NON_FINITE);
    CHECK(strlen(scree_last_error(world).cure) > 0);
    CHECK(scree_step(world, -1.0f, 8, 3) != SCREE_OK);
    CHECK(scree_soft_step(world, 1.0f / 60.0f, 0) != SCREE_OK);
    body.type = 7;
    CHECK(scree_create_body(world, &body).index == -1 && scree_last_error(world).code == SCREE_OUT_OF_RANGE);
    CHECK(scree_add_polygon(world, boxes[0], NULL, line, 3).index == -1);
    CHECK(scree_add_polygon(world, boxes[0], NULL, NULL, 3).index == -1);
    CHECK(scree_add_loop(world, boxes[0], NULL, line, 2).index == -1);
    CHECK(scree_add_circle(world, boxes[0], NULL, zero, -1.0f).index == -1);
    CHECK(scree_create_joint(world, NULL).index == -1 && scree_last_error(world).code == SCREE_NULL_ARGUMENT);
    CHECK(scree_create_joint(world, &joint).index == -1 && scree_last_error(world).code == SCREE_FOREIGN_HANDLE);
    joint.body_a = boxes[0], joint.body_b = boxes[1], joint.hertz = -1.0f;
    CHECK(scree_create_joint(world, &joint).index == -1 && scree_last_error(world).code == SCREE_OUT_OF_RANGE);
    CHECK(scree_state_hash(world) == before);
    settings.gravity = bad;
    CHECK(scree_create_world(&settings, &why) == NULL && why.code == SCREE_NON_FINITE && strlen(why.field) > 0);

    joint.hertz = 2.0f, joint.damping_ratio = 0.5f;
    for (int type = SCREE_REVOLUTE; type <= SCREE_WHEEL; ++type) {
        scree_joint made;
        joint.type = type;
        joint.anchor_b.x = 1.0f;
        made = scree_create_joint(world, &joint);
        CHECK(made.index >= 0);
        CHECK(scree_destroy_joint(world, made) == SCREE_OK);
        CHECK(scree_destroy_joint(world, made) == SCREE_FOREIGN_HANDLE);
    }

    CHECK(scree_destroy_body(world, boxes[3]) == SCREE_OK);
    CHECK(scree_destroy_body(world, boxes[3]) == SCREE_FOREIGN_HANDLE);
    {
        const scree_body next = scree_create_body(world, NULL); /* in the slot that is free now */
        CHECK(next.index == boxes[3].index && next.generation != boxes[3].generation);
        CHECK(scree_apply_force(world, boxes[3], zero, zero) == SCREE_FOREIGN_HANDLE);
        CHECK(scree_get_mass(world, boxes[3]) == 0.0f);
    }
    scree_destroy_world(world);
    scree_destroy_world(NULL);
}

static void check_images(void) {
    scree_body boxes[boxCount];
    scree_world* world = make_pile(boxes);
    size_t size;
    char* image;
    scree_world* copy;
    for (int i = 0; i < 40; ++i) scree_step(world, 1.0f / 60.0f, 8, 3);
    size = scree_save_world(world, NULL, 0);
    image = malloc(size);
    CHECK(image != NULL && scree_save_world(world, image, size) == size);
    copy = scree_load_world(image, size);
    CHECK(copy != NULL && scree_load_world(image, size - 1) == NULL && scree_load_world(NULL, 0) == NULL);
    for (int i = 0; i < 40; ++i) scree_step(world, 1.0f / 60.0f, 8, 3), scree_step(copy, 1.0f / 60.0f, 8, 3);
    CHECK(scree_state_hash(world) == scree_state_hash(copy));
    free(image);
    scree_destroy_world(copy);
    scree_destroy_world(world);
}

int main(void) {
    check_rows_and_events();
    check_ids_and_errors();
    check_images();
    if (failures == 0) printf("all is well\n");
    return failures == 0 ? 0 : 1;
}
