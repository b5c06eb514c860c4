// SPDX-License-Identifier: BSD-2-Clause
#include "serve/wall.h"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/utsname.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <utility>

namespace soarbox::serve {
namespace {

namespace fs = std::filesystem;

enum Missing : unsigned { kNoNetwork = 1, kNoLandlock = 2, kNoFilter = 4, kNoCount = 8 };

std::vector<std::string> SentencesOf(unsigned missing) {
  std::vector<std::string> sentences;
  if ((missing & kNoNetwork) != 0)
    sentences.emplace_back(
        "this system does not let the server create user namespaces: worlds share the server's network");
  if ((missing & kNoCount) != 0)
    sentences.emplace_back(
        "this system counts the processes of all worlds together: a world may start any number of processes");
  if ((missing & kNoLandlock) != 0)
    sentences.emplace_back("this system has no Landlock: only the interpreters keep a world within its own files");
  if ((missing & kNoFilter) != 0)
    sentences.emplace_back("this system has no seccomp filters: only the interpreters prevent system calls of a world");
  return sentences;
}

bool WriteTo(const char* path, const std::string& text) {
  const int file = open(path, O_WRONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool is_written = write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  close(file);
  return is_written;
}

/// Whether the kernel counts processes per user namespace: Linux 5.14 and newer. Older kernels count all processes of
/// the user, including those of other places.
bool CountsByNamespace() {
  utsname system{};
  int major = 0, minor = 0;
  if (uname(&system) != 0 || std::sscanf(system.release, "%d.%d", &major, &minor) != 2) return false;
  return std::pair(major, minor) >= std::pair(5, 14);
}

/// Creates a user namespace, in which processes are counted separately, with an empty network if requested. Returns
/// what is missing.
unsigned TakeNetwork(bool may_connect) {
  const uid_t user = getuid();
  const gid_t group = getgid();
  if (unshare(CLONE_NEWUSER | (may_connect ? 0 : CLONE_NEWNET)) != 0) return kNoNetwork | kNoCount;
  // Maps the user to itself, so that files keep their owner.
  WriteTo("/proc/self/setgroups", "deny");
  const std::string same_user = std::to_string(user) + " " + std::to_string(user) + " 1";
  const std::string same_group = std::to_string(group) + " " + std::to_string(group) + " 1";
  WriteTo("/proc/self/uid_map", same_user);
  WriteTo("/proc/self/gid_map", same_group);
  if (!CountsByNamespace()) return kNoCount;
  // The run itself, its threads, and the process that grades a lesson with one process for each core.
  const rlim_t most = 64 + 2 * static_cast<rlim_t>(std::max(sysconf(_SC_NPROCESSORS_ONLN), 1l));
  const rlimit limit{most, most};
  if (setrlimit(RLIMIT_NPROC, &limit) != 0) return kNoCount;
  return 0;
}

// Rights that are newer than the headers of this build.
constexpr std::uint64_t kTruncate = 1ull << 14, kConnections = 3, kScopes = 3;
constexpr std::uint64_t kRead = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t kAllFirst = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1;

/// The newest version of the structure; a kernel uses the part that it supports.
struct RuleSet {
  std::uint64_t files, network, scopes;
};

class Landlock {
 public:
  explicit Landlock(bool may_connect) {
    const long version = syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    if (version < 1) return;
    files_ = kAllFirst | (version >= 2 ? LANDLOCK_ACCESS_FS_REFER : 0) | (version >= 3 ? kTruncate : 0);
    const RuleSet rules{files_, version >= 4 && !may_connect ? kConnections : 0, version >= 6 ? kScopes : 0};
    const std::size_t size = version >= 6 ? sizeof rules : version >= 4 ? 2 * sizeof files_ : sizeof files_;
    set_ = static_cast<int>(syscall(SYS_landlock_create_ruleset, &rules, size, 0));
  }
  ~Landlock() {
    if (set_ >= 0) close(set_);
  }
  Landlock(const Landlock&) = delete;
  Landlock& operator=(const Landlock&) = delete;

  void Allow(const fs::path& path, std::uint64_t rights) const {
    const int at = open(path.c_str(), O_PATH | O_CLOEXEC);
    if (at < 0) return;
    struct stat what {};
    constexpr std::uint64_t kOfFiles =
        LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_READ_FILE | kTruncate;
    if (fstat(at, &what) == 0) {
      landlock_path_beneath_attr beneath{};
      beneath.allowed_access = rights & files_ & (S_ISDIR(what.st_mode) ? files_ : kOfFiles);
      beneath.parent_fd = at;
      syscall(SYS_landlock_add_rule, set_, LANDLOCK_RULE_PATH_BENEATH, &beneath, 0);
    }
    close(at);
  }
  bool Restrict() const { return set_ >= 0 && syscall(SYS_landlock_restrict_self, set_, 0) == 0; }
  std::uint64_t all() const { return files_ & ~std::uint64_t{LANDLOCK_ACCESS_FS_EXECUTE}; }

 private:
  int set_ = -1;
  std::uint64_t files_ = 0;
};

bool TakeFiles(const WallSettings& settings) {
  const Landlock landlock(settings.may_connect);
  // Files that the loader and the C library read, but no folder with programs.
  for (const char* path : {"/lib", "/lib64", "/usr/lib", "/usr/lib64", "/usr/local/lib", "/usr/share/zoneinfo",
                           "/usr/share/locale", "/etc/ld.so.cache", "/etc/localtime", "/dev/urandom", "/proc/self",
                           "/proc/meminfo", "/proc/cpuinfo", "/proc/stat", "/sys/devices/system/cpu"})
    landlock.Allow(path, kRead);
  landlock.Allow("/dev/null", kRead | LANDLOCK_ACCESS_FS_WRITE_FILE);
  // To grade lessons, this program starts itself, for which the system needs the program and the loader.
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  for (const fs::path& part :
       {program, fs::path("/lib64/ld-linux-x86-64.so.2"), fs::path("/lib/ld-linux-aarch64.so.1")})
    landlock.Allow(part, LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE);
  // Libraries that were installed with it, outside of the system's folders.
  for (const char* libraries : {"lib", "lib64"}) landlock.Allow(program.parent_path().parent_path() / libraries, kRead);
  for (const fs::path& folder : settings.readable) landlock.Allow(folder, kRead);
  for (const fs::path& folder : settings.writable) landlock.Allow(folder, landlock.all());
  return landlock.Restrict();
}

#if defined(__x86_64__)
constexpr std::uint32_t kMachine = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kMachine = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t kMachine = 0;
#endif

/// System calls that no world needs. They fail with EPERM.
constexpr std::array kRefused{
    SYS_ptrace,
    SYS_process_vm_readv,
    SYS_process_vm_writev,
    SYS_mount,
    SYS_umount2,
    SYS_pivot_root,
    SYS_chroot,
    SYS_setns,
    SYS_unshare,
    SYS_bpf,
    SYS_perf_event_open,
    SYS_add_key,
    SYS_request_key,
    SYS_keyctl,
    SYS_init_module,
    SYS_finit_module,
    SYS_delete_module,
    SYS_kexec_load,
    SYS_reboot,
    SYS_swapon,
    SYS_swapoff,
    SYS_userfaultfd,
    SYS_io_uring_setup,
    SYS_io_uring_enter,
    SYS_io_uring_register,
    SYS_pidfd_getfd,
    SYS_pidfd_send_signal,
    SYS_open_by_handle_at,
    SYS_name_to_handle_at,
    SYS_move_mount,
    SYS_open_tree,
    SYS_fsopen,
    SYS_fsmount,
    SYS_acct,
    SYS_quotactl,
    SYS_settimeofday,
    SYS_clock_settime,
    SYS_sethostname,
    SYS_personality,
    SYS_syslog,
};
constexpr std::array kOfNetwork{SYS_socket, SYS_connect, SYS_bind, SYS_listen, SYS_accept, SYS_accept4};

bool FilterCalls(bool may_connect) {
  if (kMachine == 0) return false;
  std::vector<sock_filter> program;
  const auto add = [&](std::uint16_t code, std::uint32_t value, std::uint8_t yes = 0, std::uint8_t no = 0) {
    program.push_back({code, yes, no, value});
  };
  const std::uint32_t refuse = SECCOMP_RET_ERRNO | EPERM;
  // Calls of another architecture have other numbers: they end the process.
  add(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch));
  add(BPF_JMP | BPF_JEQ | BPF_K, kMachine, 1, 0);
  add(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS);
  add(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr));
#if defined(__x86_64__)
  constexpr std::uint32_t kX32 = 0x40000000;
  add(BPF_JMP | BPF_JGE | BPF_K, kX32, 0, 1);
  add(BPF_RET | BPF_K, refuse);
#endif
  const auto refuse_call = [&](long number) {
    add(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(number), 0, 1);
    add(BPF_RET | BPF_K, refuse);
  };
  for (const long number : kRefused) refuse_call(number);
  if (!may_connect)
    for (const long number : kOfNetwork) refuse_call(number);
  add(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
  const sock_fprog filter{static_cast<unsigned short>(program.size()), program.data()};
  return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter, 0, 0) == 0;
}

unsigned Raise(const WallSettings& settings) {
  unsigned missing = TakeNetwork(settings.may_connect);
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return missing | kNoLandlock | kNoFilter;
  if (!TakeFiles(settings)) missing |= kNoLandlock;
  if (!FilterCalls(settings.may_connect)) missing |= kNoFilter;
  return missing;
}

}  // namespace

std::vector<std::string> RaiseWall(const WallSettings& settings) {
  return SentencesOf(Raise(settings));
}

std::vector<std::string> MissingOfWall() {
  const pid_t pid = fork();
  if (pid == 0) _exit(static_cast<int>(Raise({})));
  int status = 0;
  if (pid < 0 || waitpid(pid, &status, 0) != pid || !WIFEXITED(status))
    return SentencesOf(kNoNetwork | kNoLandlock | kNoFilter | kNoCount);
  return SentencesOf(static_cast<unsigned>(WEXITSTATUS(status)));
}

}  // namespace soarbox::serve
