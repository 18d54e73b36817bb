// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace quadcut::opencl {

/// There is no device, or one of its calls failed. The message says which, and why.
class DeviceError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// What a test wants to go wrong: the driver is made to fail, so that its own errors are seen.
enum class Fault : std::uint8_t {
    none,
    /// Kernels that do not compile.
    build,
    /// More memory asked for than there is.
    memory,
    /// A launch that the driver refuses, as it refuses all once a device is lost.
    launch,
    /// Kernels that compute something else.
    result,
    /// As `memory`, but not before the device has proved itself.
    late,
    /// The process ends as soon as a device is looked for.
    death,
};

/// A handle of the driver, given back with the last copy of it.
using Handle = std::shared_ptr<void>;

/// When a command is done, others may begin.
struct Event {
    Handle handle;
};

/// Memory of the device.
struct Buffer {
    Handle handle;
    std::size_t num_bytes = 0;
};

struct Library;
class Device;

/// A function of the device, with its arguments.
class Kernel {
public:
    /// Buffers, and numbers of 4 or 8 bytes. They keep until they are set again.
    template <typename... Args>
    void set(const Args&... arguments) {
        std::uint32_t place = 0;
        (set_one(place++, arguments), ...);
    }

private:
    friend class Device;
    friend class Queue;
    void set_one(std::uint32_t place, const Buffer& buffer);
    template <typename T>
        requires std::is_arithmetic_v<T>
    void set_one(std::uint32_t place, const T& number) { set_bytes(place, &number, sizeof(T)); }
    void set_bytes(std::uint32_t place, const void* bytes, std::size_t num_bytes);

    const Library* library_ = nullptr;
    Handle program_;
    Handle handle_;
};

/// Commands that run one after the other; those of two queues overlap, unless they wait for an
/// event. All of them return at once, and take pointers that must hold until finish().
class Queue {
public:
    using Events = std::vector<Event>;

    Event write(const Buffer& buffer, const void* source, std::size_t num_bytes,
                const Events& after = {});
    Event read(const Buffer& buffer, void* target, std::size_t num_bytes, const Events& after);
    Event fill_with_zeros(const Buffer& buffer);
    /// `size` work-items by `steps`.
    Event launch(const Kernel& kernel, std::size_t size, std::size_t steps, const Events& after);
    /// Makes a buffer readable here: the pointer is good once the event is there.
    std::pair<const void*, Event> map(const Buffer& buffer, std::size_t num_bytes,
                                      const Events& after);
    Event unmap(const Buffer& buffer, const void* mapped);
    /// Sees to it that the commands begin.
    void flush();
    /// Waits for an event. Throws DeviceError if its command failed.
    void wait(const Event& event) const;
    /// Waits for all commands; they may have failed.
    void finish() noexcept;

private:
    friend class Device;
    const Library* library_ = nullptr;
    Fault fault_ = Fault::none;
    Handle handle_;
};

/// Where a buffer lives: on the device, or where both sides reach it fast (pinned).
enum class Placement : std::uint8_t { device, shared };

/// A device of OpenCL 1.2 or later. Everything here throws DeviceError when the driver fails.
class Device {
public:
    /// Loads the library (a name for dlopen) and finds the device with the most compute units,
    /// among GPUs and accelerators first; a CPU is one only with `accept_cpu`.
    static Device find(const std::string& library, bool accept_cpu, Fault fault);

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] bool is_cpu() const { return is_cpu_; }
    /// cl_khr_fp64.
    [[nodiscard]] bool has_doubles() const { return has_doubles_; }
    /// Whether the device works in the memory of the CPU.
    [[nodiscard]] bool shares_memory() const { return shares_memory_; }

    /// The kernels of one program, by name.
    [[nodiscard]] std::vector<Kernel> build(std::string_view source,
                                            const std::vector<const char*>& names) const;
    [[nodiscard]] Buffer allocate(std::size_t num_bytes,
                                  Placement placement = Placement::device) const;
    [[nodiscard]] Queue make_queue() const;

private:
    std::shared_ptr<const Library> library_;
    Fault fault_ = Fault::none;
    Handle context_;
    void* device_ = nullptr;
    std::string name_;
    bool is_cpu_ = false;
    bool has_doubles_ = false;
    bool shares_memory_ = false;
};

}  // namespace quadcut::opencl
