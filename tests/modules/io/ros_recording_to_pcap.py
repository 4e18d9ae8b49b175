"""Writes the Velodyne packets of a rosbag2 recording (velodyne_msgs/VelodyneScan in SQLite, CDR) as a pcap file."""
import glob
import sqlite3
import struct
import sys

PACKET = 1206


def packets(message):
    """(seconds, bytes) of each packet of one serialised VelodyneScan."""
    at = 4 + 8  # encapsulation header, stamp
    (length,) = struct.unpack_from("<I", message, at)
    at = (at + 4 + length + 3) // 4 * 4
    (count,) = struct.unpack_from("<I", message, at)
    at += 4
    for _ in range(count):
        seconds, nanoseconds = struct.unpack_from("<II", message, at)
        yield seconds + 1e-9 * nanoseconds, message[at + 8 : at + 8 + PACKET]
        at = (at + 8 + PACKET + 3) // 4 * 4


def main(folder, out):
    (database,) = glob.glob(folder + "/*/*.db3")
    rows = sqlite3.connect(f"file:{database}?mode=ro&immutable=1", uri=True).execute("select data from messages order by id").fetchall()
    with open(out, "wb") as file:
        file.write(struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 65535, 1))
        for (message,) in rows:
            for time, payload in packets(message):
                udp = struct.pack(">HHHH", 2368, 2368, 8 + len(payload), 0) + payload
                ip = struct.pack(">BBHHHBBH4s4s", 0x45, 0, 20 + len(udp), 0, 0, 64, 17, 0, bytes(4), bytes(4)) + udp
                frame = bytes(12) + b"\x08\x00" + ip
                file.write(struct.pack("<IIII", int(time), int(time % 1 * 1e6), len(frame), len(frame)) + frame)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
