{% extends "three/solid.d.ts" %}
{% block import %}
import { BoxGeometry, Mesh } from "three";
import { MeshPhysicalNodeMaterial } from "three/webgpu";
{% endblock %}
{% block material %}MeshPhysicalNodeMaterial{% endblock %}
