// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "opencl/device.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <optional>

#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>
#include <dlfcn.h>

namespace quadcut::opencl {

/// The functions of libOpenCL that are used, by name: linking would make every start of the program
/// need and load it.
struct Library {
    explicit Library(const std::string& name) : handle(open(name)) {}

    // Never unloaded: drivers leave threads and handlers of exit behind. First, since the functions
    // are looked up in it.
    void* handle;
    decltype(&clGetPlatformIDs) get_platforms = find("clGetPlatformIDs");
    decltype(&clGetDeviceIDs) get_devices = find("clGetDeviceIDs");
    decltype(&clGetDeviceInfo) get_device_info = find("clGetDeviceInfo");
    decltype(&clCreateContext) create_context = find("clCreateContext");
    decltype(&clReleaseContext) release_context = find("clReleaseContext");
    decltype(&clCreateCommandQueue) create_queue = find("clCreateCommandQueue");
    decltype(&clReleaseCommandQueue) release_queue = find("clReleaseCommandQueue");
    decltype(&clCreateProgramWithSource) create_program = find("clCreateProgramWithSource");
    decltype(&clBuildProgram) build_program = find("clBuildProgram");
    decltype(&clGetProgramBuildInfo) get_build_info = find("clGetProgramBuildInfo");
    decltype(&clReleaseProgram) release_program = find("clReleaseProgram");
    decltype(&clCreateKernel) create_kernel = find("clCreateKernel");
    decltype(&clSetKernelArg) set_argument = find("clSetKernelArg");
    decltype(&clReleaseKernel) release_kernel = find("clReleaseKernel");
    decltype(&clCreateBuffer) create_buffer = find("clCreateBuffer");
    decltype(&clReleaseMemObject) release_memory = find("clReleaseMemObject");
    decltype(&clEnqueueWriteBuffer) write = find("clEnqueueWriteBuffer");
    decltype(&clEnqueueReadBuffer) read = find("clEnqueueReadBuffer");
    decltype(&clEnqueueFillBuffer) fill = find("clEnqueueFillBuffer");
    decltype(&clEnqueueNDRangeKernel) launch = find("clEnqueueNDRangeKernel");
    decltype(&clEnqueueMapBuffer) map = find("clEnqueueMapBuffer");
    decltype(&clEnqueueUnmapMemObject) unmap = find("clEnqueueUnmapMemObject");
    decltype(&clFlush) flush = find("clFlush");
    decltype(&clFinish) finish = find("clFinish");
    decltype(&clWaitForEvents) wait = find("clWaitForEvents");
    decltype(&clReleaseEvent) release_event = find("clReleaseEvent");

private:
    /// The address of a function, of whatever type.
    struct Symbol {
        void* address;
        template <typename Function>
        operator Function*() const {  // NOLINT(google-explicit-constructor)
            return reinterpret_cast<Function*>(address);
        }
    };
    static void* open(const std::string& name) {
        void* const opened = ::dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (opened == nullptr) throw DeviceError("there is no OpenCL library (" + name + ")");
        return opened;
    }
    [[nodiscard]] Symbol find(const char* name) const {
        void* const address = ::dlsym(handle, name);
        if (address == nullptr) {
            throw DeviceError(std::string("the OpenCL library has no ") + name +
                              " (OpenCL 1.2 is needed)");
        }
        return {address};
    }
};

namespace {

/// Work-items of a group; sizes are rounded up to whole ones.
constexpr std::size_t kGroup = 64;

void check(cl_int status, const std::string& what) {
    if (status == CL_SUCCESS) return;
    std::string why = "error " + std::to_string(status);
    if (status == CL_MEM_OBJECT_ALLOCATION_FAILURE || status == CL_OUT_OF_RESOURCES ||
        status == CL_INVALID_BUFFER_SIZE || status == CL_OUT_OF_HOST_MEMORY) {
        why = "out of memory, " + why;
    }
    throw DeviceError(what + ": " + why);
}

std::string info_text(const Library& library, cl_device_id device, cl_device_info key) {
    std::size_t num_bytes = 0;
    check(library.get_device_info(device, key, 0, nullptr, &num_bytes), "asking the device");
    std::string text(num_bytes, '\0');
    check(library.get_device_info(device, key, num_bytes, text.data(), nullptr),
          "asking the device");
    while (!text.empty() && text.back() == '\0') text.pop_back();
    return text;
}

template <typename T>
T info_number(const Library& library, cl_device_id device, cl_device_info key) {
    T number{};
    check(library.get_device_info(device, key, sizeof(T), &number, nullptr), "asking the device");
    return number;
}

std::vector<cl_device_id> all_devices(const Library& library) {
    // The loader says "no platform" as an error.
    cl_uint num_platforms = 0;
    if (library.get_platforms(0, nullptr, &num_platforms) != CL_SUCCESS) num_platforms = 0;
    std::vector<cl_platform_id> platforms(num_platforms);
    if (num_platforms > 0) {
        check(library.get_platforms(num_platforms, platforms.data(), nullptr), "OpenCL");
    }
    std::vector<cl_device_id> devices;
    for (const cl_platform_id platform : platforms) {
        cl_uint count = 0;
        if (library.get_devices(platform, CL_DEVICE_TYPE_ALL, 0, nullptr, &count) != CL_SUCCESS) {
            continue;
        }
        const std::size_t before = devices.size();
        devices.resize(before + count);
        check(library.get_devices(platform, CL_DEVICE_TYPE_ALL, count, devices.data() + before,
                                  nullptr),
              "OpenCL");
    }
    return devices;
}

bool is_cpu_device(const Library& library, cl_device_id device) {
    const auto type = info_number<cl_device_type>(library, device, CL_DEVICE_TYPE);
    return (type & (CL_DEVICE_TYPE_GPU | CL_DEVICE_TYPE_ACCELERATOR)) == 0;
}

bool can_be_used(const Library& library, cl_device_id device) {
    // "OpenCL 1.0 ..." and "OpenCL 1.1 ..." lack clEnqueueFillBuffer and more.
    const std::string version = info_text(library, device, CL_DEVICE_VERSION);
    return info_number<cl_bool>(library, device, CL_DEVICE_AVAILABLE) != CL_FALSE &&
           info_number<cl_bool>(library, device, CL_DEVICE_COMPILER_AVAILABLE) != CL_FALSE &&
           info_number<cl_bool>(library, device, CL_DEVICE_ENDIAN_LITTLE) != CL_FALSE &&
           version.rfind("OpenCL 1.0", 0) != 0 && version.rfind("OpenCL 1.1", 0) != 0;
}

std::vector<cl_event> handles_of(const Queue::Events& events) {
    std::vector<cl_event> handles;
    handles.reserve(events.size());
    for (const Event& event : events) handles.push_back(static_cast<cl_event>(event.handle.get()));
    return handles;
}

/// An empty list must be none.
const cl_event* list_of(const std::vector<cl_event>& events) {
    return events.empty() ? nullptr : events.data();
}

cl_mem memory_of(const Buffer& buffer) { return static_cast<cl_mem>(buffer.handle.get()); }

cl_command_queue queue_of(const Handle& handle) {
    return static_cast<cl_command_queue>(handle.get());
}

/// What an enqueuing call gives.
Event event_of(const Library& library, cl_int status, cl_event event, const char* what) {
    check(status, what);
    return {Handle(
        event, [&library](void* handle) { library.release_event(static_cast<cl_event>(handle)); })};
}

}  // namespace

void Kernel::set_one(std::uint32_t place, const Buffer& buffer) {
    cl_mem memory = memory_of(buffer);
    set_bytes(place, static_cast<const void*>(&memory), sizeof(void*));
}

void Kernel::set_bytes(std::uint32_t place, const void* bytes, std::size_t num_bytes) {
    check(library_->set_argument(static_cast<cl_kernel>(handle_.get()), place, num_bytes, bytes),
          "setting an argument of a kernel");
}

Event Queue::write(const Buffer& buffer, const void* source, std::size_t num_bytes,
                   const Events& after) {
    // The driver refuses to write nothing.
    if (num_bytes == 0) return fill_with_zeros(buffer);
    const std::vector<cl_event> waits = handles_of(after);
    cl_event event = nullptr;
    const cl_int status =
        library_->write(queue_of(handle_), memory_of(buffer), CL_FALSE, 0, num_bytes, source,
                        static_cast<cl_uint>(waits.size()), list_of(waits), &event);
    return event_of(*library_, status, event, "writing to the device");
}

Event Queue::read(const Buffer& buffer, void* target, std::size_t num_bytes, const Events& after) {
    const std::vector<cl_event> waits = handles_of(after);
    cl_event event = nullptr;
    const cl_int status =
        library_->read(queue_of(handle_), memory_of(buffer), CL_FALSE, 0, num_bytes, target,
                       static_cast<cl_uint>(waits.size()), list_of(waits), &event);
    return event_of(*library_, status, event, "reading from the device");
}

Event Queue::fill_with_zeros(const Buffer& buffer) {
    const cl_uint zero = 0;
    cl_event event = nullptr;
    const cl_int status = library_->fill(queue_of(handle_), memory_of(buffer), &zero, sizeof zero,
                                         0, buffer.num_bytes, 0, nullptr, &event);
    return event_of(*library_, status, event, "filling memory of the device");
}

Event Queue::launch(const Kernel& kernel, std::size_t size, std::size_t steps,
                    const Events& after) {
    const std::vector<cl_event> waits = handles_of(after);
    const std::array<std::size_t, 2> global{(size + kGroup - 1) / kGroup * kGroup, steps};
    // No device has so large a group.
    const std::size_t group = fault_ == Fault::launch ? std::size_t{1} << 40U : kGroup;
    const std::array<std::size_t, 2> local{group, 1};
    cl_event event = nullptr;
    const cl_int status = library_->launch(
        queue_of(handle_), static_cast<cl_kernel>(kernel.handle_.get()), 2, nullptr, global.data(),
        local.data(), static_cast<cl_uint>(waits.size()), list_of(waits), &event);
    return event_of(*library_, status, event, "launching a kernel");
}

std::pair<const void*, Event> Queue::map(const Buffer& buffer, std::size_t num_bytes,
                                         const Events& after) {
    const std::vector<cl_event> waits = handles_of(after);
    cl_event event = nullptr;
    cl_int status = CL_SUCCESS;
    const void* const mapped =
        library_->map(queue_of(handle_), memory_of(buffer), CL_FALSE, CL_MAP_READ, 0, num_bytes,
                      static_cast<cl_uint>(waits.size()), list_of(waits), &event, &status);
    return {mapped, event_of(*library_, status, event, "mapping memory of the device")};
}

Event Queue::unmap(const Buffer& buffer, const void* mapped) {
    cl_event event = nullptr;
    const cl_int status = library_->unmap(queue_of(handle_), memory_of(buffer),
                                          const_cast<void*>(mapped), 0, nullptr, &event);
    return event_of(*library_, status, event, "unmapping memory of the device");
}

void Queue::flush() { check(library_->flush(queue_of(handle_)), "starting the device"); }

void Queue::wait(const Event& event) const {
    auto* const handle = static_cast<cl_event>(event.handle.get());
    check(library_->wait(1, &handle), "waiting for the device");
}

void Queue::finish() noexcept { (void)library_->finish(queue_of(handle_)); }

Device Device::find(const std::string& library, bool accept_cpu, Fault fault) {
    if (fault == Fault::death) std::abort();
    Device found;
    found.library_ = std::make_shared<Library>(library);
    found.fault_ = fault;
    const Library& opencl = *found.library_;
    std::optional<std::pair<bool, cl_uint>> best;
    for (const cl_device_id device : all_devices(opencl)) {
        const bool is_cpu = is_cpu_device(opencl, device);
        if ((is_cpu && !accept_cpu) || !can_be_used(opencl, device)) continue;
        const std::pair rank{!is_cpu,
                             info_number<cl_uint>(opencl, device, CL_DEVICE_MAX_COMPUTE_UNITS)};
        if (best.has_value() && rank <= *best) continue;
        best = rank;
        found.device_ = device;
    }
    if (!best.has_value()) {
        throw DeviceError(accept_cpu ? "there is no OpenCL device" : "there is no OpenCL GPU");
    }
    auto* const device = static_cast<cl_device_id>(found.device_);
    found.name_ = info_text(opencl, device, CL_DEVICE_NAME);
    found.is_cpu_ = is_cpu_device(opencl, device);
    found.has_doubles_ =
        info_text(opencl, device, CL_DEVICE_EXTENSIONS).find("cl_khr_fp64") != std::string::npos;
    found.shares_memory_ =
        info_number<cl_bool>(opencl, device, CL_DEVICE_HOST_UNIFIED_MEMORY) != CL_FALSE;
    cl_int status = CL_SUCCESS;
    cl_context context = opencl.create_context(nullptr, 1, &device, nullptr, nullptr, &status);
    check(status, "taking " + found.name_ + " into use");
    found.context_ = Handle(context, [&opencl](void* handle) {
        opencl.release_context(static_cast<cl_context>(handle));
    });
    return found;
}

std::vector<Kernel> Device::build(std::string_view source,
                                  const std::vector<const char*>& names) const {
    const Library& opencl = *library_;
    auto* const device = static_cast<cl_device_id>(device_);
    const char* text = source.data();
    const std::size_t length = source.size();
    cl_int status = CL_SUCCESS;
    cl_program program =
        opencl.create_program(static_cast<cl_context>(context_.get()), 1, &text, &length, &status);
    check(status, "taking in the kernels");
    const Handle handle(program,
                        [&opencl](void* p) { opencl.release_program(static_cast<cl_program>(p)); });
    std::string options = "-cl-std=CL1.2";
    if (fault_ == Fault::build) options += " -DScene=1";
    if (fault_ == Fault::result) options += " -DREACH2=400";
    status = opencl.build_program(program, 1, &device, options.c_str(), nullptr, nullptr);
    if (status != CL_SUCCESS) {
        std::string log(4096, '\0');
        std::size_t num_bytes = 0;
        (void)opencl.get_build_info(program, device, CL_PROGRAM_BUILD_LOG, log.size(), log.data(),
                                    &num_bytes);
        log.resize(std::min(num_bytes, log.find('\n')));
        check(status, "its compiler refuses the kernels (" + log + ")");
    }
    std::vector<Kernel> kernels;
    for (const char* const name : names) {
        Kernel kernel;
        kernel.library_ = library_.get();
        kernel.program_ = handle;
        cl_kernel made = opencl.create_kernel(program, name, &status);
        check(status, std::string("taking in the kernel ") + name);
        kernel.handle_ =
            Handle(made, [&opencl](void* k) { opencl.release_kernel(static_cast<cl_kernel>(k)); });
        kernels.push_back(std::move(kernel));
    }
    return kernels;
}

Buffer Device::allocate(std::size_t num_bytes, Placement placement) const {
    // No buffer is empty.
    Buffer buffer{{}, std::max<std::size_t>(num_bytes, 16)};
    // The check against the CPU asks for less than this.
    const bool is_refused =
        fault_ == Fault::memory || (fault_ == Fault::late && num_bytes > std::size_t{1} << 18U);
    const std::size_t size =
        is_refused ? std::numeric_limits<std::size_t>::max() / 2 : buffer.num_bytes;
    const cl_mem_flags flags =
        CL_MEM_READ_WRITE | (placement == Placement::shared ? CL_MEM_ALLOC_HOST_PTR : 0);
    cl_int status = CL_SUCCESS;
    cl_mem memory = library_->create_buffer(static_cast<cl_context>(context_.get()), flags, size,
                                            nullptr, &status);
    check(status, "asking for " + std::to_string(size) + " bytes of its memory");
    buffer.handle = Handle(memory, [library = library_.get()](void* handle) {
        library->release_memory(static_cast<cl_mem>(handle));
    });
    return buffer;
}

Queue Device::make_queue() const {
    cl_int status = CL_SUCCESS;
    cl_command_queue made = library_->create_queue(static_cast<cl_context>(context_.get()),
                                                   static_cast<cl_device_id>(device_), 0, &status);
    check(status, "opening a queue");
    Queue queue;
    queue.library_ = library_.get();
    queue.fault_ = fault_;
    queue.handle_ = Handle(made, [library = library_.get()](void* handle) {
        library->release_queue(static_cast<cl_command_queue>(handle));
    });
    return queue;
}

}  // namespace quadcut::opencl
