"""A client with pvserver on two processes: the plugin is loaded on both sides, and the points lie on both processes."""

import os
import pathlib
import socket
import subprocess
import time

import bole_paraview
import paraview_test as t
from paraview import servermanager, simple

SERVER_PROCESSES = 2


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


def start_server(port):
    as_root = ["--allow-run-as-root"] if os.geteuid() == 0 else []
    command = ["mpirun", "--oversubscribe", *as_root, "-np", str(SERVER_PROCESSES), "pvserver", f"--server-port={port}"]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def connect(server, port):
    for line in server.stdout:
        print(line, end="")
        if "Accepting connection" in line:
            break
    for _ in range(20):
        try:
            return simple.Connect("localhost", port)
        except RuntimeError:
            time.sleep(0.5)
    raise RuntimeError("no connection to pvserver")


def test(data):
    port = free_port()
    server = start_server(port)
    try:
        connection = connect(server, port)
        t.check(connection is not None and connection.IsRemote(), "the client has no server")
        bole_paraview.load_plugin()
        t.equal(connection.GetNumberOfDataPartitions(), SERVER_PROCESSES, "processes of the server")
        copc = str(pathlib.Path(data) / "copc" / "octree.copc.laz")
        reader = bole_paraview.stage("io.read_cloud", {"file": copc, "unit": "metre", "up": "z"})
        reader.UpdatePipeline()
        t.equal(reader.GetDataInformation().GetNumberOfPoints(), 700, "points of the pieces")
        processes = simple.ProcessIdScalars(Input=reader) if hasattr(simple, "ProcessIdScalars") else simple.ProcessIds(Input=reader)
        processes.UpdatePipeline()
        arrays = processes.PointData
        found = next((arrays[name] for name in arrays.keys() if "rocess" in name), None)
        t.check(found is not None and found.GetRange() == (0.0, 1.0), "the points do not lie on both processes")
        points = bole_paraview.stage("survey.join_trajectory", {}, {"points": (reader, "points")})
        points.UpdatePipeline()
        t.equal(points.GetDataInformation().GetNumberOfPoints(), 700, "points of the stage")
        t.equal(bole_paraview.report(reader).get("facts", {}).get("format"), "COPC", "the format in the report")
        simple.Disconnect()
    finally:
        server.terminate()
        server.wait(timeout=30)


t.run(test, load=False)
