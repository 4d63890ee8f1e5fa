// Lets the programs work on the files and streams of Node instead of those in memory.
import fs from 'node:fs';
import path from 'node:path';
import tty from 'node:tty';

// Numbers of errors in Emscripten's C library, which are those of WASI.
const errorNumbers = {
  EACCES: 2, EAGAIN: 6, EBADF: 8, EBUSY: 10, EDQUOT: 19, EEXIST: 20, EFBIG: 22, EINTR: 27, EINVAL: 28,
  EIO: 29, EISDIR: 31, ELOOP: 32, EMFILE: 33, ENAMETOOLONG: 37, ENFILE: 41, ENODEV: 43, ENOENT: 44,
  ENOMEM: 48, ENOSPC: 51, ENOSYS: 52, ENOTDIR: 54, ENOTEMPTY: 55, ENOTSUP: 58, ENOTTY: 59, ENXIO: 60,
  EPERM: 63, EPIPE: 64, EROFS: 69, ESPIPE: 70, ETXTBSY: 74, EXDEV: 75,
};
// Flags of open() in Emscripten's C library, which are those of Linux.
const openFlags = {
  O_WRONLY: 0o1, O_RDWR: 0o2, O_CREAT: 0o100, O_EXCL: 0o200, O_TRUNC: 0o1000, O_APPEND: 0o2000,
  O_NONBLOCK: 0o4000, O_DIRECTORY: 0o200000, O_NOFOLLOW: 0o400000,
};
// An exit code as the shell gives it to a program that SIGPIPE has ended.
const exitOfClosedPipe = 141;

const seek = { current: 1, end: 2 };

function flagsOfNode(flags) {
  let result = 0;
  for (const [name, bit] of Object.entries(openFlags))
    if (flags & bit) result |= fs.constants[name] ?? 0;
  return result;
}

/** Reads what a pipe has; Windows reports the end of a pipe as an error. */
function readSome(fd, bytes, offset, length, position) {
  for (;;) {
    try {
      return fs.readSync(fd, bytes, offset, length, position);
    } catch (error) {
      if (error.code === 'EOF') return 0;
      if (error.code !== 'EAGAIN') throw error;
      Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 5);
    }
  }
}

function writeSome(fd, bytes, offset, length, position) {
  for (;;) {
    try {
      return fs.writeSync(fd, bytes, offset, length, position);
    } catch (error) {
      if (error.code === 'EPIPE') process.exit(exitOfClosedPipe);
      if (error.code !== 'EAGAIN') throw error;
      Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 5);
    }
  }
}

function streamFunctions(module, FS) {
  const isKnownPosition = (stream, position) => position !== undefined || stream.seekable;
  const at = (stream, position) =>
    isKnownPosition(stream, position) ? position ?? stream.position : null;
  const bytesOf = (array) => new Uint8Array(array.buffer);
  return {
    open(name, flags, mode, wanted) {
      const nfd = fs.openSync(name, flagsOfNode(flags), mode);
      const status = fs.fstatSync(nfd);
      if (flags & openFlags.O_DIRECTORY && !status.isDirectory()) {
        fs.closeSync(nfd);
        throw new FS.ErrnoError(errorNumbers.ENOTDIR);
      }
      const fd = wanted ?? FS.nextfd(3);
      const node = { id: status.ino, mode: status.mode, path: name };
      const seekable = status.isFile() && !(flags & openFlags.O_APPEND);
      FS.streams[fd] = { fd, nfd, position: 0, path: name, flags, node, seekable, tty: tty.isatty(nfd) };
      return FS.streams[fd];
    },
    close(stream) {
      fs.closeSync(stream.nfd);
      FS.streams[stream.fd] = null;
    },
    llseek(stream, offset, whence) {
      if (!stream.seekable && !stream.node?.mode) throw new FS.ErrnoError(errorNumbers.ESPIPE);
      const base = whence === seek.current ? stream.position
        : whence === seek.end ? fs.fstatSync(stream.nfd).size : 0;
      if (base + offset < 0) throw new FS.ErrnoError(errorNumbers.EINVAL);
      stream.position = base + offset;
      return stream.position;
    },
    read(stream, buffer, offset, length, position) {
      const count = readSome(stream.nfd, bytesOf(buffer), offset, length, at(stream, position));
      if (position === undefined) stream.position += count;
      return count;
    },
    write(stream, buffer, offset, length, position) {
      const count = writeSome(stream.nfd, bytesOf(buffer), offset, length, at(stream, position));
      if (position === undefined) stream.position += count;
      return count;
    },
    // A copy: memory of the module cannot be that of a file. Programs map files to read them alone.
    mmap(stream, address, length, position) {
      const ptr = module.mmapAlloc(length);
      readSome(stream.nfd, bytesOf(module.HEAP8), ptr, length, position);
      return { ptr, allocated: true };
    },
    munmap: () => 0,
    msync: () => 0,
    ftruncate(fd, length) {
      fs.ftruncateSync(FS.streams[fd].nfd, length);
    },
    fchmod(fd, mode) {
      fs.fchmodSync(FS.streams[fd].nfd, mode);
    },
  };
}

function pathFunctions(FS) {
  const nodeOf = (name) => {
    const status = fs.lstatSync(name);
    return { id: status.ino, mode: status.mode, path: name };
  };
  return {
    lookupPath(name, options) {
      const wanted = options?.parent ? path.dirname(name) : name;
      return { path: wanted, node: nodeOf(wanted) };
    },
    lookupNode: (parent, name) => nodeOf(path.join(parent.path, name)),
    nodePermissions(node, wanted) {
      const names = { r: fs.constants.R_OK, w: fs.constants.W_OK, x: fs.constants.X_OK };
      const mode = [...wanted].reduce((sum, letter) => sum | names[letter], 0);
      try {
        fs.accessSync(node.path, mode);
        return 0;
      } catch (error) {
        return errorNumbers[error.code] ?? errorNumbers.EACCES;
      }
    },
    cwd: () => process.cwd(),
    chdir: (name) => process.chdir(name),
    mkdir: (name, mode) => fs.mkdirSync(name, mode),
    mkdirTree: (name, mode) => fs.mkdirSync(name, { recursive: true, mode }),
    rmdir: (name) => fs.rmdirSync(name),
    readdir: (name) => ['.', '..', ...fs.readdirSync(name)],
    rename: (from, to) => fs.renameSync(from, to),
    unlink: (name) => fs.unlinkSync(name),
    symlink: (target, name) => fs.symlinkSync(target, name),
    readlink: (name) => fs.readlinkSync(name),
    stat: (name) => fs.statSync(name),
    lstat: (name) => fs.lstatSync(name),
    chmod: (name, mode) => fs.chmodSync(name, mode),
    truncate: (name, length) => fs.truncateSync(name, length),
    utime: (name, access, change) => fs.utimesSync(name, access / 1000, change / 1000),
  };
}

/** Replaces the functions of Emscripten's file system, and the three open streams. */
export function useFilesOfNode(module) {
  const { FS } = module;
  const wrapped = (call) => (...words) => {
    try {
      return call(...words);
    } catch (error) {
      if (!(error.code in errorNumbers)) throw error;
      throw new FS.ErrnoError(errorNumbers[error.code]);
    }
  };
  for (const [name, call] of Object.entries({ ...streamFunctions(module, FS), ...pathFunctions(FS) }))
    FS[name] = wrapped(call);
  ['/dev/stdin', '/dev/stdout', '/dev/stderr'].forEach((name, fd) => {
    const isTerminal = tty.isatty(fd);
    FS.streams[fd] = { fd, nfd: fd, position: 0, path: name, flags: fd && 1, tty: isTerminal, seekable: false };
  });
}
