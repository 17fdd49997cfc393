// The scene "{{ title }}" beside ordinary meshes under three.js's lights, or as its own picture.

import {
    BoxGeometry, DataTexture, DirectionalLight, EquirectangularReflectionMapping, Group, LinearFilter, MathUtils, Mesh, MeshStandardMaterial,
    PerspectiveCamera, PlaneGeometry, Scene, SRGBColorSpace, Vector3,
} from "three";
import GUI from "three/addons/libs/lil-gui.module.min.js";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { BOX, PARAMETERS, VIEW } from "./scene.js";

/** Shows a solid, or the picture of the same scene, with one of three.js's renderers. */
export function show(renderer, solid, picture) {
    // Scenes are in millimetres, and z is up; three.js is used to metres, and y.
    const model = new Group();
    model.rotation.x = -Math.PI / 2;
    model.scale.setScalar(0.001);
    model.add(solid, picture);
    model.updateMatrixWorld();

    const scene = new Scene();
    scene.environment = sky();
    scene.background = scene.environment;
    const ordinary = surroundings();
    scene.add(model, ordinary);

    const size = extent();
    const camera = new PerspectiveCamera(VIEW.fieldOfView, 1, size / 100, size * 100);
    const controls = new OrbitControls(camera, renderer.domElement);
    const target = model.localToWorld(new Vector3(...VIEW.target));
    const eye = model.localToWorld(new Vector3(...VIEW.eye));

    let isWanted = true;
    const draw = () => (isWanted = true);
    controls.addEventListener("change", draw);

    const gui = new GUI({ title: {{ title | tojson }} });
    const shown = { picture: location.hash === "#picture" };
    const choose = () => {
        picture.visible = shown.picture;
        solid.visible = ordinary.visible = !shown.picture;
        // The scene's own view, or from farther off, so that there is room for what stands beside.
        controls.target.copy(target);
        camera.position.lerpVectors(target, eye, shown.picture ? 1 : 1.4);
        controls.update();
        draw();
    };
    gui.add(shown, "picture").name("its own light").onChange(choose);
    choose();
    for (const { name, label, text, min, max, step, is_time } of PARAMETERS) {
        const slider = gui.add(solid.parameters, name, min, max, step).name(is_time ? "time" : label);
        slider.domElement.title = text;
        slider.onChange((value) => {
            picture.parameters[name] = value;
            if (is_time) solid.period = picture.period = 0;
            draw();
        });
    }

    renderer.shadowMap.enabled = true;
    document.body.append(renderer.domElement);
    const resize = () => {
        renderer.setPixelRatio(devicePixelRatio);
        renderer.setSize(innerWidth, innerHeight);
        camera.aspect = innerWidth / innerHeight;
        // What fits into the view's own format fits into all narrower ones.
        const halfHeight = Math.tan(MathUtils.degToRad(VIEW.fieldOfView / 2)) * Math.max(1, VIEW.aspect / camera.aspect);
        camera.fov = MathUtils.radToDeg(2 * Math.atan(halfHeight));
        camera.updateProjectionMatrix();
        draw();
    };
    addEventListener("resize", resize);
    resize();

    renderer.setAnimationLoop(() => {
        if (!isWanted && !(solid.period > 0)) return;
        isWanted = false;
        renderer.render(scene, camera);
        document.body.dataset.drawn = "yes";
    });
}

/** A floor, a post and a sun. */
function surroundings() {
    const size = extent();
    const [x, y, z] = [0, 1, 2].map((axis) => (BOX.min[axis] + BOX.max[axis]) / 2000);
    const low = BOX.min[2] / 1000;
    const center = new Vector3(x, z, -y);
    const ordinary = new Group();

    const floor = new Mesh(new PlaneGeometry(6 * size, 6 * size), new MeshStandardMaterial({ color: "#d8d4cc", roughness: 0.9 }));
    floor.rotation.x = -Math.PI / 2;
    floor.position.set(x, low, -y);
    floor.receiveShadow = true;

    // Between the sun and the solid, so that each throws a shadow onto what is behind.
    const width = 0.1 * size;
    const height = (1.2 * (BOX.max[2] - BOX.min[2])) / 1000;
    const towardsSun = new Vector3(1.2, 0.9, 0.5);
    const post = new Mesh(new BoxGeometry(width, height, width), new MeshStandardMaterial({ color: "#c0392b", roughness: 0.5 }));
    post.position.copy(towardsSun).setY(0).setLength(0.6 * size).add(center).setY(low + height / 2);
    post.castShadow = post.receiveShadow = true;

    const sun = new DirectionalLight("white", 3);
    sun.position.copy(center).add(towardsSun.clone().multiplyScalar(size));
    sun.target.position.copy(center);
    sun.castShadow = true;
    sun.shadow.mapSize.set(1024, 1024);
    sun.shadow.radius = 2;
    // A ray finds the surface that is lit from the light's side, too: without a distance it would shade itself.
    sun.shadow.normalBias = 0.01 * size;
    Object.assign(sun.shadow.camera, { left: -size, right: size, top: size, bottom: -size, near: 0.1 * size, far: 4 * size });

    return ordinary.add(floor, post, sun, sun.target);
}

/** An environment: dark below, bright above. */
function sky() {
    const rows = [[70, 66, 60], [120, 118, 115], [170, 180, 195], [215, 225, 240]];
    const texture = new DataTexture(new Uint8Array(rows.flatMap((row) => [...row, 255])), 1, rows.length);
    Object.assign(texture, { mapping: EquirectangularReflectionMapping, colorSpace: SRGBColorSpace, magFilter: LinearFilter });
    texture.needsUpdate = true;
    return texture;
}

/** The diagonal of the scene's box in metres. */
function extent() {
    return Math.hypot(...BOX.max.map((most, axis) => most - BOX.min[axis])) / 1000;
}
