{% extends "three/solid.d.ts" %}
{% block import %}
import { BoxGeometry, Mesh, MeshPhysicalMaterial } from "three";
{% endblock %}
{% block material %}MeshPhysicalMaterial{% endblock %}
