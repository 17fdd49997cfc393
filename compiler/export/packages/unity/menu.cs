// Adds {{ title }} to the menus GameObject > Chiaro, in Unity's editor. Written by Chiaro {{ version }}; CC0 1.0.
using System.IO;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering;

public static class {{ type_name }}Menu
{
    // The box that the scene is in, in metres with y up.
    static readonly Vector3 Least = new Vector3({{ (box_min[0] / 1000) | float }}f, {{ (box_min[2] / 1000) | float }}f, {{ (box_min[1] / 1000) | float }}f);
    static readonly Vector3 Greatest = new Vector3({{ (box_max[0] / 1000) | float }}f, {{ (box_max[2] / 1000) | float }}f, {{ (box_max[1] / 1000) | float }}f);

    [MenuItem("GameObject/Chiaro/{{ title }}", false, 10)]
    static void AddSolid(MenuCommand command)
    {
        Add(command, "{{ title }}", "Chiaro/{{ title }}", new Bounds((Least + Greatest) / 2, Greatest - Least));
    }

    [MenuItem("GameObject/Chiaro/{{ title }} with its own light", false, 10)]
    static void AddPicture(MenuCommand command)
    {
        // It fills every view, wherever it is.
        var picture = Add(command, "{{ title }} picture", "Chiaro/{{ title }} picture", new Bounds(Vector3.zero, 1e6f * Vector3.one));
        picture.GetComponent<MeshRenderer>().shadowCastingMode = ShadowCastingMode.Off;
        if (Camera.main == null) return;
        var eye = new Vector3({{ (eye[0] / 1000) | float }}f, {{ (eye[2] / 1000) | float }}f, {{ (eye[1] / 1000) | float }}f);
        var target = new Vector3({{ (target[0] / 1000) | float }}f, {{ (target[2] / 1000) | float }}f, {{ (target[1] / 1000) | float }}f);
        var up = new Vector3({{ up[0] | float }}f, {{ up[2] | float }}f, {{ up[1] | float }}f);
        Undo.RecordObject(Camera.main, "Look at {{ title }}");
        Undo.RecordObject(Camera.main.transform, "Look at {{ title }}");
        Camera.main.transform.SetPositionAndRotation(eye, Quaternion.LookRotation(target - eye, up));
        Camera.main.fieldOfView = {{ field_of_view | float }}f;
        Camera.main.nearClipPlane = 0.02f * (target - eye).magnitude;
    }

    static GameObject Add(MenuCommand command, string name, string shader, Bounds bounds)
    {
        var added = new GameObject(name, typeof(MeshFilter), typeof(MeshRenderer));
        added.GetComponent<MeshFilter>().sharedMesh = Asset(name + " box.asset", () => Box(bounds));
        added.GetComponent<MeshRenderer>().sharedMaterial = Asset(name + ".mat", () => new Material(Shader.Find(shader)));
        GameObjectUtility.SetParentAndAlign(added, command.context as GameObject);
        Undo.RegisterCreatedObjectUndo(added, "Add " + name);
        Selection.activeObject = added;
        return added;
    }

    // An asset beside this folder's shaders, made once.
    static T Asset<T>(string name, System.Func<T> make) where T : Object
    {
        var shader = AssetDatabase.GetAssetPath(Shader.Find("Chiaro/{{ title }}"));
        var path = Path.GetDirectoryName(shader).Replace('\\', '/') + "/" + name;
        var asset = AssetDatabase.LoadAssetAtPath<T>(path);
        if (asset != null) return asset;
        asset = make();
        AssetDatabase.CreateAsset(asset, path);
        return asset;
    }

    // A box of eight corners, whose normals point away from its centre.
    static Mesh Box(Bounds bounds)
    {
        var corners = new Vector3[8];
        var normals = new Vector3[8];
        for (var i = 0; i < 8; i++)
        {
            var side = new Vector3((i & 1) * 2 - 1, (i >> 1 & 1) * 2 - 1, (i >> 2 & 1) * 2 - 1);
            corners[i] = bounds.center + Vector3.Scale(side, bounds.extents);
            normals[i] = side.normalized;
        }
        int[] triangles =
        {
            0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
            2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5,
        };
        return new Mesh { vertices = corners, normals = normals, triangles = triangles, bounds = bounds };
    }
}
