// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A reference to something that can be called, for the time of one call: two words, no allocation, nothing copied. What
// std::function would own, this only points at, so it may be a parameter and never a member that outlives the call.

#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

namespace scree {

template <typename Signature>
class FunctionRef;

template <typename Result, typename... Arguments>
class FunctionRef<Result(Arguments...)> {
public:
    /// Refers to nothing.
    FunctionRef(std::nullptr_t = nullptr) {}  // NOLINT(google-explicit-constructor)

    /// Refers to `callable`, which must outlive the reference. A null pointer to a function and an empty std::function
    /// are nothing.
    template <typename Callable>
    requires(!std::same_as<std::remove_cvref_t<Callable>, FunctionRef> &&
             std::is_invocable_r_v<Result, Callable&, Arguments...>)
        FunctionRef(Callable&& callable) {  // NOLINT(google-explicit-constructor)
        using Target = std::remove_reference_t<Callable>;
        if constexpr (std::is_function_v<Target>) {
            m_target.function = reinterpret_cast<Function*>(&callable);
        } else {
            if constexpr (std::is_pointer_v<Target> || IsStdFunction<std::remove_cv_t<Target>>::value) {
                if (callable == nullptr) return;
            }
            m_target.object = const_cast<void*>(static_cast<const void*>(std::addressof(callable)));
        }
        m_call = [](Place target, Arguments... arguments) -> Result {
            if constexpr (std::is_function_v<Target>) {
                return (*reinterpret_cast<Target*>(target.function))(std::forward<Arguments>(arguments)...);
            } else {
                return (*static_cast<Target*>(target.object))(std::forward<Arguments>(arguments)...);
            }
        };
    }

    Result operator()(Arguments... arguments) const { return m_call(m_target, std::forward<Arguments>(arguments)...); }
    friend bool operator==(const FunctionRef& f, std::nullptr_t) { return f.m_call == nullptr; }

private:
    using Function = void();
    union Place {
        void* object;
        Function* function;
    };
    template <typename T>
    struct IsStdFunction : std::false_type {};
    template <typename T>
    struct IsStdFunction<std::function<T>> : std::true_type {};

    Place m_target{nullptr};
    Result (*m_call)(Place, Arguments...) = nullptr;
};

}  // namespace scree
