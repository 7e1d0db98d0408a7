// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Worlds whose tasks run on the threads of a program: their bits, how many tasks a step has, and what else the program
// does with its threads meanwhile.

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <random>
#include <thread>
#include <vector>

#include "scree/scree.h"
#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

/// Threads of a program, and a queue of tasks for them.
class Program {
public:
    explicit Program(int threads) {
        for (int i = 0; i < threads; ++i) m_threads.emplace_back([this] { Work(); });
    }
    ~Program() {
        {
            const std::lock_guard lock(m_mutex);
            m_quits = true;
        }
        m_wakes.notify_all();
        for (std::thread& thread : m_threads) thread.join();
    }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    struct Task {
        void (*run)(void*);
        void* context;
        bool isDone = false;
    };
    std::shared_ptr<Task> Start(void (*run)(void*), void* context) {
        auto task = std::make_shared<Task>(Task{run, context});
        {
            const std::lock_guard lock(m_mutex);
            m_queue.push_back(task);
        }
        m_wakes.notify_one();
        return task;
    }
    /// Without doing anything meanwhile; false if it takes a minute.
    bool Wait(const Task& task) {
        std::unique_lock lock(m_mutex);
        return m_ends.wait_for(lock, std::chrono::minutes(1), [&] { return task.isDone; });
    }
    [[nodiscard]] TaskCallbacks GetCallbacks() {
        return {.enqueue = [](void (*task)(void*), void* context, void* program) -> void* {
                    auto* self = static_cast<Program*>(program);
                    ++self->taskCount;
                    return new std::shared_ptr<Task>(self->Start(task, context));
                },
                .finish =
                    [](void* handle, void* program) {
                        const std::unique_ptr<std::shared_ptr<Task>> task(static_cast<std::shared_ptr<Task>*>(handle));
                        EXPECT_TRUE(static_cast<Program*>(program)->Wait(**task));
                    },
                .context = this};
    }

    int taskCount = 0;  ///< of worlds

private:
    void Work() {
        std::unique_lock lock(m_mutex);
        for (;;) {
            m_wakes.wait(lock, [this] { return m_quits || !m_queue.empty(); });
            if (m_queue.empty()) return;
            const std::shared_ptr<Task> task = m_queue.front();
            m_queue.pop_front();
            lock.unlock();
            task->run(task->context);
            lock.lock();
            task->isDone = true;
            m_ends.notify_all();
        }
    }

    std::mutex m_mutex;
    std::condition_variable m_wakes, m_ends;
    std::deque<std::shared_ptr<Task>> m_queue;
    bool m_quits = false;
    std::vector<std::thread> m_threads;
};

WorldDef DefOf(SolverKind solver, int workers, const TaskCallbacks& tasks) {
    WorldDef def;
    def.gravity = {0.0f, -10.0f};
    def.solver = solver;
    def.workerCount = workers;
    def.tasks = tasks;
    return def;
}

/// Enough for steps to be shared.
void AddHeap(World& world, unsigned seed) {
    std::mt19937 random(seed);
    AddGround(world);
    const int base = std::uniform_int_distribution(28, 40)(random);
    for (int row = 0; row < base; ++row) {
        for (int i = 0; i < base - row; ++i) {
            const float x = 1.03f * (static_cast<float>(i) - 0.5f * static_cast<float>(base - row));
            Body* body = AddBody(world, dynamicBody, {x, 0.5f + 1.02f * static_cast<float>(row)});
            random() % 4 == 0 ? AddCircle(body, 0.5f) : AddBox(body, 0.5f, 0.5f);
        }
    }
}

TEST(TaskSystem, StepsHaveTheBitsOfOneThreadWithAnyNumberOfThreadsAndTasks) {
    constexpr int steps = 12;
    for (const SolverKind solver : {SolverKind::sequentialImpulses, SolverKind::softStep}) {
        for (const unsigned seed : {1u, 2u, 3u}) {
            World one(DefOf(solver, 1, {}));
            AddHeap(one, seed);
            StepFor(one, steps);
            for (const int threads : {1, 3}) {
                for (const int tasksPerWorker : {0, 2}) {
                    SCOPED_TRACE(testing::Message()
                                 << "seed " << seed << ", " << threads << " threads, " << tasksPerWorker << " tasks");
                    Program program(threads);
                    TaskCallbacks tasks = program.GetCallbacks();
                    tasks.tasksPerWorker = tasksPerWorker;
                    const int workers = 2 + static_cast<int>(seed);
                    World many(DefOf(solver, workers, tasks));
                    AddHeap(many, seed);
                    StepFor(many, steps);
                    EXPECT_EQ(BitsOf(one), BitsOf(many));
                    EXPECT_GE(program.taskCount, steps * (workers - 1));
                }
            }
        }
    }
}

/// Waits in each call for a task of its own.
class Waiting : public ContactListener {
public:
    explicit Waiting(Program& program) : m_program(program) {}
    void BeginContact(Contact*) override {
        if (++calls % 50 != 0 || !isDone) return;
        const auto task = m_program.Start([](void* context) { ++*static_cast<int*>(context); }, &done);
        isDone = m_program.Wait(*task);
        ++waits;
    }
    int calls = 0, waits = 0, done = 0;
    bool isDone = true;

private:
    Program& m_program;
};

// The world's tasks have all of the program's threads for as long as a step lasts.
TEST(TaskSystem, AListenerMayWaitForItsOwnTasks) {
    for (const SolverKind solver : {SolverKind::sequentialImpulses, SolverKind::softStep}) {
        Program program(2);
        Waiting listener(program);
        World world(DefOf(solver, 3, program.GetCallbacks()));
        world.SetContactListener(&listener);
        AddHeap(world, 7);
        StepFor(world, 5);
        EXPECT_TRUE(listener.isDone);
        EXPECT_GT(listener.waits, 5);
        EXPECT_EQ(listener.done, listener.waits);
    }
}

}  // namespace
}  // namespace scree::test
