# SPDX-License-Identifier: BSD-2-Clause
"""A member of an exercise, written from the standard and independent of our code: it receives and sends PDUs (IEEE 1278.1), and
has its own formulas for positions on the earth."""
import math
import socket
import struct
import time

ANCHOR = (47.3976, 8.5486, 408)


def geocentric(latitude_deg, longitude_deg, height_m):
    a, b = 6378137.0, 6356752.314245179
    latitude, longitude = math.radians(latitude_deg), math.radians(longitude_deg)
    n = a * a / math.hypot(a * math.cos(latitude), b * math.sin(latitude))
    return ((n + height_m) * math.cos(latitude) * math.cos(longitude),
            (n + height_m) * math.cos(latitude) * math.sin(longitude),
            (n * b * b / (a * a) + height_m) * math.sin(latitude))


def on_earth(x_m, y_m, z_m, anchor=ANCHOR):
    """The position on the earth of a place in the flat world: x points east, y up, -z north."""
    latitude, longitude = math.radians(anchor[0]), math.radians(anchor[1])
    origin = geocentric(*anchor)
    east = (-math.sin(longitude), math.cos(longitude), 0)
    north = (-math.sin(latitude) * math.cos(longitude), -math.sin(latitude) * math.sin(longitude), math.cos(latitude))
    up = (math.cos(latitude) * math.cos(longitude), math.cos(latitude) * math.sin(longitude), math.sin(latitude))
    return tuple(origin[i] + east[i] * x_m + up[i] * y_m - north[i] * z_m for i in range(3))


def pdu(kind, family, body, version=7, exercise=1):
    return struct.pack(">BBBBIHH", version, exercise, kind, family, 0, 12 + len(body), 0) + body


def entity_state(entity, place, force=2, kind=(3, 1, 225, 1, 1, 0, 0), appearance=1 << 16, marking="visitor",
                 velocity=(0, 0, 0), orientation=(0, 0, 0), **header):
    return pdu(1, 1, struct.pack(">HHHBBBBHBBBBBBHBBBB", *entity, force, 0, *kind, *([0] * 7))
               + struct.pack(">fff", *velocity) + struct.pack(">ddd", *place) + struct.pack(">fff", *orientation)
               + struct.pack(">IB15x", appearance, 2) + bytes(24) + bytes([1]) + marking.encode().ljust(11, b"\0")
               + struct.pack(">I", 0), **header)


def detonation(shooter, target, place, result=1, munition=(2, 8, 0, 2, 1, 0, 0)):
    return pdu(3, 2, struct.pack(">HHHHHHHHHHHH", *shooter, *target, 0, 0, 0, shooter[0], shooter[1], 1) + bytes(12)
               + struct.pack(">ddd", *place) + struct.pack(">BBHBBBBHHHH", *munition, 0, 0, 1, 0) + bytes(12)
               + bytes([result, 0, 0, 0]))


def order(kind, to, request=7):
    """Start/Resume (13), Stop/Freeze (14), Create Entity (11) or Remove Entity (12)."""
    rest = {13: bytes(16), 14: bytes(12)}.get(kind, b"")
    return pdu(kind, 5, struct.pack(">HHHHHH", 9, 9, 0, *to) + rest + struct.pack(">I", request))


class Member:
    """Takes part in an exercise on this machine, in a multicast group that is limited to it."""

    def __init__(self, port, group="239.1.2.3"):
        self.to = (group, port)
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 22)
        self.socket.bind(self.to)
        here = socket.inet_aton("127.0.0.1")
        self.socket.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, socket.inet_aton(group) + here)
        self.socket.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, here)

    def close(self):
        self.socket.close()

    def say(self, datagram):
        self.socket.sendto(datagram, self.to)

    def hear(self, limit_s=100):
        """The next datagram; nothing if none arrives in this time."""
        self.socket.settimeout(limit_s)
        try:
            return self.socket.recv(65536)
        except TimeoutError:
            return None

    def hear_until(self, wanted, limit_s=100):
        """Datagrams up to the first one for which `wanted` is true, or None at the end if there is none."""
        heard = []
        end = time.monotonic() + limit_s
        while (left := end - time.monotonic()) > 0:
            datagram = self.hear(left)
            heard.append(datagram)
            if datagram is None or wanted(datagram):
                return heard
        return heard + [None]


def kind_of(datagram):
    return datagram[2]


def entity_of(datagram):
    return struct.unpack(">HHH", datagram[12:18])


def place_of(datagram):
    return struct.unpack(">ddd", datagram[48:72])


def damage_of(datagram):
    return struct.unpack(">I", datagram[84:88])[0] >> 3 & 3


def write_capture(path, datagrams, port):
    """A file of packets in the format of network tools (pcap, raw IPv4)."""
    with open(path, "wb") as file:
        file.write(struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 65535, 228))
        for number, datagram in enumerate(datagrams):
            udp = struct.pack(">HHHH", port, port, 8 + len(datagram), 0) + datagram
            ip = struct.pack(">BBHHHBBH4s4s", 0x45, 0, 20 + len(udp), number & 0xFFFF, 0, 64, 17, 0,
                             socket.inet_aton("127.0.0.1"), socket.inet_aton("239.1.2.3"))
            file.write(struct.pack("<IIII", number, 0, len(ip + udp), len(ip + udp)) + ip + udp)
