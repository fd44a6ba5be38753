/* forficula, MIT; with three.js and uPlot, MIT: see LICENSES.txt; sources 2178a4f5b0900b76aa424fd9e60adddc872246c054da72f1b250e6bbc6319f4f */
(()=>{function S(n,e={},...t){let i=document.createElement(n);for(let[s,r]of Object.entries(e))s.includes("-")||s==="role"?i.setAttribute(s,r):i[s]=r;return i.append(...t),i}function us(n,e,t){let i=S("button",{type:"button",title:e,"aria-label":e},n);return i.addEventListener("click",t),i}var ml=n=>Ih(n,24);function Ih(n,e){let t="http://www.w3.org/2000/svg",i=document.createElementNS(t,"svg");i.setAttribute("viewBox",`0 0 ${e} ${e}`),e!==24&&i.setAttribute("preserveAspectRatio","none"),i.setAttribute("aria-hidden","true");let s=document.createElementNS(t,"path");return s.setAttribute("d",n),i.append(s),i}function pr({colour:n,dash:e,area:t}){let i="http://www.w3.org/2000/svg",s=document.createElementNS(i,"svg");s.setAttribute("viewBox","0 0 24 8"),s.setAttribute("aria-hidden","true"),s.classList.add("sample");let r=document.createElementNS(i,"path");return r.setAttribute("d",t?"M0 0H24V8H0Z":"M0 4H24"),t&&(r.style.fill=n),r.setAttribute("stroke",t?"none":n),r.setAttribute("stroke-dasharray",e.join(" ")),s.append(r),s}var Xp=3,Lv=1e4;function mr(n,e){let t=URL.createObjectURL(n);S("a",{href:t,download:e}).click(),setTimeout(()=>URL.revokeObjectURL(t),Lv)}function qn(n){return`${document.title.split(/: | with /)[0]} ${n}`.toLowerCase().normalize("NFKD").replace(/[^a-z0-9.]+/g,"-").replace(/^-+|-+$/g,"")||"plot"}function gl(n,e,t){let i=S("button",{type:"button","aria-label":`download ${n} of ${e}`,title:`download as ${n}`},n);return i.addEventListener("click",t),i}function Xi(n,e,t){let i=()=>mr(new Blob([t().svg],{type:"image/svg+xml"}),`${e()}.svg`);return S("span",{className:"saves"},gl("PNG",n,async()=>mr(await Nv(t()),`${e()}.png`)),gl("SVG",n,i))}async function Nv({svg:n,width:e,height:t}){let i=URL.createObjectURL(new Blob([n],{type:"image/svg+xml"}));try{let s=S("img",{width:e,height:t});await new Promise((o,a)=>{s.onload=o,s.onerror=a,s.src=i});let r=S("canvas",{width:Xp*e,height:Xp*t});return r.getContext("2d").drawImage(s,0,0,r.width,r.height),await new Promise(o=>r.toBlob(o,"image/png"))}finally{URL.revokeObjectURL(i)}}function qp(){for(let n of document.querySelectorAll("figure.drawn")){let[e,t]=[n.querySelector("img"),n.querySelector("source")],i=n.closest("section")?.id??"figure",s=[["PNG",e.src],["SVG",t.srcset]].map(([r,o])=>gl(r,`the figure ${i}`,()=>mr(Dv(o),`${qn(i)}.${r.toLowerCase()}`)));n.append(S("div",{className:"saves save-foot"},...s))}}function Dv(n){let[e,t]=n.split(","),i=atob(t);return new Blob([Uint8Array.from(i,s=>s.charCodeAt(0))],{type:/:(.*?);/.exec(e)[1]})}function Ot(n){return`${n[0]?.toUpperCase()??""}${n.slice(1)}`}function Nn(n,e){let t=n.toFixed(e);return(Number(t)===0?0 .toFixed(e):t).replace("-","−")}function Lh(n,e){return n.replace(/\{(\w+)\}/g,(t,i)=>e[i])}function bt(n){let e=Number(n.toPrecision(4)),t=Math.abs(e);return(t!==0&&(t>=1e5||t<.001)?n.toExponential(2):String(e)).replaceAll("-","−")}var Nh={};function Yp(n){Nh=n}function Zp(n,e){let t=Nh[n],[i,s]=t.find(([,,r])=>e>=r||e===0)??t.at(-1);return{unit:i,factor:s}}function Kp(n){return Object.values(Nh).flat().find(([e])=>e===n)[1]}function ks(n,e){let{unit:t,factor:i}=Zp(e,Math.abs(n));return`${bt(i*n)} ${t}`}function na(n){return n.unit?{unit:n.unit,factor:1}:Zp("s",Math.max(Math.abs(n.start),Math.abs(n.end)))}function qi(n,e){let{unit:t,factor:i}=na(e),s=Math.ceil(2.7-Math.log10(i*(e.end-e.start)));return`${Nn(i*n,Math.min(6,Math.max(0,s)))} ${t}`}var Zs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Ks={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Rm=0,cd=1,Pm=2;var Oa=1,Im=2,bo=3,Js=0,Kn=1,zn=2,Mr=0,So=1,ud=2,hd=3,dd=4,Lm=5;var wr=100,Nm=101,Dm=102,Om=103,Um=104,km=200,Fm=201,Bm=202,zm=203,fd=204,pd=205,Vm=206,Gm=207,Hm=208,Wm=209,$m=210,Xm=211,qm=212,Ym=213,Zm=214,Gl=0,Hl=1,Wl=2,co=3,$l=4,Xl=5,ql=6,Yl=7,vc=0,Km=1,Jm=2,es=0,md=1,gd=2,xd=3,_d=4,yd=5,vd=6,bd=7;var Sd=300,Ar=301,Mo=302,bc=303,Sc=304,Zl=1e3,Ki=1001,Kl=1002,In=1003,jm=1004;var Ua=1005;var Zn=1006,Mc=1007;var Ms=1008;var ei=1009,Md=1010,wd=1011,wo=1012,wc=1013,Ii=1014,bi=1015,Li=1016,Ac=1017,Ec=1018,Er=1020,Ad=35902,Ed=35899,Td=1021,Cd=1022,Ni=1023,xs=1026,ws=1027,Tc=1028,Cc=1029,js=1030,Rc=1031;var Pc=1033,ka=33776,Fa=33777,Ba=33778,za=33779,Ic=35840,Lc=35841,Nc=35842,Dc=35843,Oc=36196,Uc=37492,kc=37496,Fc=37488,Bc=37489,Va=37490,zc=37491,Vc=37808,Gc=37809,Hc=37810,Wc=37811,$c=37812,Xc=37813,qc=37814,Yc=37815,Zc=37816,Kc=37817,Jc=37818,jc=37819,Qc=37820,eu=37821,tu=36492,nu=36494,iu=36495,su=36283,ru=36284,Ga=36285,ou=36286;var fa=2300,Jl=2301,zl=2302,td=2303,nd=2400,id=2401,sd=2402;var Qm=3200;var au=0,eg=1,As="",li="srgb",pa="srgb-linear",ma="linear",Tt="srgb";var Vl=7680,Rd=7681;var Pd=517;var tg=519,ng=512,ig=513,sg=514,Id=515,rg=516,og=517,Ld=518,Nd=519,ag=35044,Ha=35048;var Dd="300 es",vi=2e3,uo=2001;function Ov(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function Uv(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function ga(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function lg(){let n=ga("canvas");return n.style.display="block",n}var Jp={},ho=null;function Od(...n){let e="THREE."+n.shift();ho?ho("log",e,...n):console.log(e,...n)}function cg(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function qe(...n){n=cg(n);let e="THREE."+n.shift();if(ho)ho("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function Qe(...n){n=cg(n);let e="THREE."+n.shift();if(ho)ho("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function ua(...n){let e=n.join(" ");e in Jp||(Jp[e]=!0,qe(...n))}function ug(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var hg={[Gl]:Gl,[Wl]:ql,[$l]:$l,[co]:Xl,[Hl]:Hl,[ql]:Wl,[Yl]:Yl,[Xl]:co},Pi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},kn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],jp=1234567,ha=Math.PI/180,fo=180/Math.PI;function Ao(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(kn[n&255]+kn[n>>8&255]+kn[n>>16&255]+kn[n>>24&255]+"-"+kn[e&255]+kn[e>>8&255]+"-"+kn[e>>16&15|64]+kn[e>>24&255]+"-"+kn[t&63|128]+kn[t>>8&255]+"-"+kn[t>>16&255]+kn[t>>24&255]+kn[i&255]+kn[i>>8&255]+kn[i>>16&255]+kn[i>>24&255]).toLowerCase()}function pt(n,e,t){return Math.max(e,Math.min(t,n))}function Ud(n,e){return(n%e+e)%e}function kv(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function Fv(n,e,t){return n!==e?(t-n)/(e-n):0}function da(n,e,t){return(1-t)*n+t*e}function Bv(n,e,t,i){return da(n,e,1-Math.exp(-t*i))}function zv(n,e=1){return e-Math.abs(Ud(n,e*2)-e)}function Vv(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function Gv(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function Hv(n,e){return n+Math.floor(Math.random()*(e-n+1))}function Wv(n,e){return n+Math.random()*(e-n)}function $v(n){return n*(.5-Math.random())}function Xv(n){n!==void 0&&(jp=n);let e=jp+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function qv(n){return n*ha}function Yv(n){return n*fo}function Zv(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function Kv(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function kd(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Jv(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),u=o((e+i)/2),h=r((e-i)/2),d=o((e-i)/2),f=r((i-e)/2),p=o((i-e)/2);switch(s){case"XYX":n.set(a*u,l*h,l*d,a*c);break;case"YZY":n.set(l*d,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*d,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*f,a*c);break;case"YXY":n.set(l*f,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*f,a*u,a*c);break;default:qe("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Fd(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function dg(n,e){if(e.constructor===Float32Array)return n;let t=Fd(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function fg(n,e){if(e.constructor===Float32Array)return n;let t=Fd(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var Bd={DEG2RAD:ha,RAD2DEG:fo,generateUUID:Ao,clamp:pt,euclideanModulo:Ud,mapLinear:kv,inverseLerp:Fv,lerp:da,damp:Bv,pingpong:zv,smoothstep:Vv,smootherstep:Gv,randInt:Hv,randFloat:Wv,randFloatSpread:$v,seededRandom:Xv,degToRad:qv,radToDeg:Yv,isPowerOfTwo:Zv,ceilPowerOfTwo:Kv,floorPowerOfTwo:kd,setQuaternionFromProperEuler:Jv,normalize:fg,denormalize:dg},Ye=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=pt(this.x,e.x,t.x),this.y=pt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=pt(this.x,e,t),this.y=pt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(pt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(pt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},ui=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],d=r[o+0],f=r[o+1],p=r[o+2],x=r[o+3];if(h!==x||l!==d||c!==f||u!==p){let g=l*d+c*f+u*p+h*x;g<0&&(d=-d,f=-f,p=-p,x=-x,g=-g);let m=1-a;if(g<.9995){let _=Math.acos(g),b=Math.sin(_);m=Math.sin(m*_)/b,a=Math.sin(a*_)/b,l=l*m+d*a,c=c*m+f*a,u=u*m+p*a,h=h*m+x*a}else{l=l*m+d*a,c=c*m+f*a,u=u*m+p*a,h=h*m+x*a;let _=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=_,c*=_,u*=_,h*=_}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return e[t]=a*p+u*h+l*f-c*d,e[t+1]=l*p+u*d+c*h-a*f,e[t+2]=c*p+u*f+a*d-l*h,e[t+3]=u*p-a*h-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),d=l(i/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"YXZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"ZXY":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"ZYX":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"YZX":this._x=d*u*h+c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h-d*f*p;break;case"XZY":this._x=d*u*h-c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h+d*f*p;break;default:qe("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(pt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},G=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Qp.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Qp.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),h=2*(r*i-o*t);return this.x=t+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=pt(this.x,e.x,t.x),this.y=pt(this.y,e.y,t.y),this.z=pt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=pt(this.x,e,t),this.y=pt(this.y,e,t),this.z=pt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(pt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Dh.copy(this).projectOnVector(e),this.sub(Dh)}reflect(e){return this.sub(Dh.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(pt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Dh=new G,Qp=new ui,et=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],f=i[5],p=i[8],x=s[0],g=s[3],m=s[6],_=s[1],b=s[4],v=s[7],E=s[2],A=s[5],y=s[8];return r[0]=o*x+a*_+l*E,r[3]=o*g+a*b+l*A,r[6]=o*m+a*v+l*y,r[1]=c*x+u*_+h*E,r[4]=c*g+u*b+h*A,r[7]=c*m+u*v+h*y,r[2]=d*x+f*_+p*E,r[5]=d*g+f*b+p*A,r[8]=d*m+f*v+p*y,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,p=t*h+i*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/p;return e[0]=h*x,e[1]=(s*c-u*i)*x,e[2]=(a*i-s*o)*x,e[3]=d*x,e[4]=(u*t-s*l)*x,e[5]=(s*r-a*t)*x,e[6]=f*x,e[7]=(i*l-c*t)*x,e[8]=(o*t-i*r)*x,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return ua("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Oh.makeScale(e,t)),this}rotate(e){return ua("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Oh.makeRotation(-e)),this}translate(e,t){return ua("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Oh.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Oh=new et,em=new et().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),tm=new et().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function jv(){let n={enabled:!0,workingColorSpace:pa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Tt&&(s.r=gs(s.r),s.g=gs(s.g),s.b=gs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Tt&&(s.r=lo(s.r),s.g=lo(s.g),s.b=lo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===As?ma:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[pa]:{primaries:e,whitePoint:i,transfer:ma,toXYZ:em,fromXYZ:tm,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:li},outputColorSpaceConfig:{drawingBufferColorSpace:li}},[li]:{primaries:e,whitePoint:i,transfer:Tt,toXYZ:em,fromXYZ:tm,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:li}}}),n}var xt=jv();function gs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function lo(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Yr,jl=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Yr===void 0&&(Yr=ga("canvas")),Yr.width=e.width,Yr.height=e.height;let s=Yr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Yr}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=ga("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=gs(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(gs(t[i]/255)*255):t[i]=gs(t[i]);return{data:t,width:e.width,height:e.height}}else return qe("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},Qv=0,po=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Qv++}),this.uuid=Ao(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Uh(s[o].image)):r.push(Uh(s[o]))}else r=Uh(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function Uh(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?jl.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(qe("Texture: Unable to serialize Texture."),{})}var eb=0,kh=new G,Qn=class n extends Pi{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=Ki,s=Ki,r=Zn,o=Ms,a=Ni,l=ei,c=n.DEFAULT_ANISOTROPY,u=As){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:eb++}),this.uuid=Ao(),this.name="",this.source=new po(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Ye(0,0),this.repeat=new Ye(1,1),this.center=new Ye(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new et,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(kh).x}get height(){return this.source.getSize(kh).y}get depth(){return this.source.getSize(kh).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){qe(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){qe(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Sd)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Zl:e.x=e.x-Math.floor(e.x);break;case Ki:e.x=e.x<0?0:1;break;case Kl:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Zl:e.y=e.y-Math.floor(e.y);break;case Ki:e.y=e.y<0?0:1;break;case Kl:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Qn.DEFAULT_IMAGE=null;Qn.DEFAULT_MAPPING=Sd;Qn.DEFAULT_ANISOTROPY=1;var Ft=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],p=l[9],x=l[2],g=l[6],m=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-x)<.01&&Math.abs(p-g)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+x)<.1&&Math.abs(p+g)<.1&&Math.abs(c+f+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let b=(c+1)/2,v=(f+1)/2,E=(m+1)/2,A=(u+d)/4,y=(h+x)/4,M=(p+g)/4;return b>v&&b>E?b<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(b),s=A/i,r=y/i):v>E?v<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),i=A/s,r=M/s):E<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(E),i=y/r,s=M/r),this.set(i,s,r,t),this}let _=Math.sqrt((g-p)*(g-p)+(h-x)*(h-x)+(d-u)*(d-u));return Math.abs(_)<.001&&(_=1),this.x=(g-p)/_,this.y=(h-x)/_,this.z=(d-u)/_,this.w=Math.acos((c+f+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=pt(this.x,e.x,t.x),this.y=pt(this.y,e.y,t.y),this.z=pt(this.z,e.z,t.z),this.w=pt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=pt(this.x,e,t),this.y=pt(this.y,e,t),this.z=pt(this.z,e,t),this.w=pt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(pt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Ql=class extends Pi{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Zn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Ft(0,0,e,t),this.scissorTest=!1,this.viewport=new Ft(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Qn({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Zn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new po(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},hi=class extends Ql{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},xa=class extends Qn{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=Ki,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var ec=class extends Qn{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=Ki,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var at=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,h,d,f,p,x,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,h,d,f,p,x,g)}set(e,t,i,s,r,o,a,l,c,u,h,d,f,p,x,g){let m=this.elements;return m[0]=e,m[4]=t,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=h,m[14]=d,m[3]=f,m[7]=p,m[11]=x,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/Zr.setFromMatrixColumn(e,0).length(),r=1/Zr.setFromMatrixColumn(e,1).length(),o=1/Zr.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let d=o*u,f=o*h,p=a*u,x=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=f+p*c,t[5]=d-x*c,t[9]=-a*l,t[2]=x-d*c,t[6]=p+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*u,f=l*h,p=c*u,x=c*h;t[0]=d+x*a,t[4]=p*a-f,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=f*a-p,t[6]=x+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*u,f=l*h,p=c*u,x=c*h;t[0]=d-x*a,t[4]=-o*h,t[8]=p+f*a,t[1]=f+p*a,t[5]=o*u,t[9]=x-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*u,f=o*h,p=a*u,x=a*h;t[0]=l*u,t[4]=p*c-f,t[8]=d*c+x,t[1]=l*h,t[5]=x*c+d,t[9]=f*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,p=a*l,x=a*c;t[0]=l*u,t[4]=x-d*h,t[8]=p*h+f,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=f*h+p,t[10]=d-x*h}else if(e.order==="XZY"){let d=o*l,f=o*c,p=a*l,x=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=d*h+x,t[5]=o*u,t[9]=f*h-p,t[2]=p*h-f,t[6]=a*u,t[10]=x*h+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(tb,e,nb)}lookAt(e,t,i){let s=this.elements;return oi.subVectors(e,t),oi.lengthSq()===0&&(oi.z=1),oi.normalize(),Fs.crossVectors(i,oi),Fs.lengthSq()===0&&(Math.abs(i.z)===1?oi.x+=1e-4:oi.z+=1e-4,oi.normalize(),Fs.crossVectors(i,oi)),Fs.normalize(),xl.crossVectors(oi,Fs),s[0]=Fs.x,s[4]=xl.x,s[8]=oi.x,s[1]=Fs.y,s[5]=xl.y,s[9]=oi.y,s[2]=Fs.z,s[6]=xl.z,s[10]=oi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],f=i[13],p=i[2],x=i[6],g=i[10],m=i[14],_=i[3],b=i[7],v=i[11],E=i[15],A=s[0],y=s[4],M=s[8],I=s[12],L=s[1],C=s[5],D=s[9],k=s[13],N=s[2],B=s[6],$=s[10],H=s[14],se=s[3],Y=s[7],Q=s[11],ie=s[15];return r[0]=o*A+a*L+l*N+c*se,r[4]=o*y+a*C+l*B+c*Y,r[8]=o*M+a*D+l*$+c*Q,r[12]=o*I+a*k+l*H+c*ie,r[1]=u*A+h*L+d*N+f*se,r[5]=u*y+h*C+d*B+f*Y,r[9]=u*M+h*D+d*$+f*Q,r[13]=u*I+h*k+d*H+f*ie,r[2]=p*A+x*L+g*N+m*se,r[6]=p*y+x*C+g*B+m*Y,r[10]=p*M+x*D+g*$+m*Q,r[14]=p*I+x*k+g*H+m*ie,r[3]=_*A+b*L+v*N+E*se,r[7]=_*y+b*C+v*B+E*Y,r[11]=_*M+b*D+v*$+E*Q,r[15]=_*I+b*k+v*H+E*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],d=e[10],f=e[14],p=e[3],x=e[7],g=e[11],m=e[15],_=l*f-c*d,b=a*f-c*h,v=a*d-l*h,E=o*f-c*u,A=o*d-l*u,y=o*h-a*u;return t*(x*_-g*b+m*v)-i*(p*_-g*E+m*A)+s*(p*b-x*E+m*y)-r*(p*v-x*A+g*y)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],d=e[10],f=e[11],p=e[12],x=e[13],g=e[14],m=e[15],_=t*a-i*o,b=t*l-s*o,v=t*c-r*o,E=i*l-s*a,A=i*c-r*a,y=s*c-r*l,M=u*x-h*p,I=u*g-d*p,L=u*m-f*p,C=h*g-d*x,D=h*m-f*x,k=d*m-f*g,N=_*k-b*D+v*C+E*L-A*I+y*M;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let B=1/N;return e[0]=(a*k-l*D+c*C)*B,e[1]=(s*D-i*k-r*C)*B,e[2]=(x*y-g*A+m*E)*B,e[3]=(d*A-h*y-f*E)*B,e[4]=(l*L-o*k-c*I)*B,e[5]=(t*k-s*L+r*I)*B,e[6]=(g*v-p*y-m*b)*B,e[7]=(u*y-d*v+f*b)*B,e[8]=(o*D-a*L+c*M)*B,e[9]=(i*L-t*D-r*M)*B,e[10]=(p*A-x*v+m*_)*B,e[11]=(h*v-u*A-f*_)*B,e[12]=(a*I-o*C-l*M)*B,e[13]=(t*C-i*I+s*M)*B,e[14]=(x*b-p*E-g*_)*B,e[15]=(u*E-h*b+d*_)*B,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,p=r*h,x=o*u,g=o*h,m=a*h,_=l*c,b=l*u,v=l*h,E=i.x,A=i.y,y=i.z;return s[0]=(1-(x+m))*E,s[1]=(f+v)*E,s[2]=(p-b)*E,s[3]=0,s[4]=(f-v)*A,s[5]=(1-(d+m))*A,s[6]=(g+_)*A,s[7]=0,s[8]=(p+b)*y,s[9]=(g-_)*y,s[10]=(1-(d+x))*y,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=Zr.set(s[0],s[1],s[2]).length(),a=Zr.set(s[4],s[5],s[6]).length(),l=Zr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ti.copy(this);let c=1/o,u=1/a,h=1/l;return Ti.elements[0]*=c,Ti.elements[1]*=c,Ti.elements[2]*=c,Ti.elements[4]*=u,Ti.elements[5]*=u,Ti.elements[6]*=u,Ti.elements[8]*=h,Ti.elements[9]*=h,Ti.elements[10]*=h,t.setFromRotationMatrix(Ti),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=vi,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(i-s),d=(t+e)/(t-e),f=(i+s)/(i-s),p,x;if(l)p=r/(o-r),x=o*r/(o-r);else if(a===vi)p=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===uo)p=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=vi,l=!1){let c=this.elements,u=2/(t-e),h=2/(i-s),d=-(t+e)/(t-e),f=-(i+s)/(i-s),p,x;if(l)p=1/(o-r),x=o/(o-r);else if(a===vi)p=-2/(o-r),x=-(o+r)/(o-r);else if(a===uo)p=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Zr=new G,Ti=new at,tb=new G(0,0,0),nb=new G(1,1,1),Fs=new G,xl=new G,oi=new G,nm=new at,im=new ui,_s=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(pt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-pt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(pt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-pt(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(pt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-pt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:qe("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return nm.makeRotationFromQuaternion(e),this.setFromRotationMatrix(nm,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return im.setFromEuler(this),this.setFromQuaternion(im,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};_s.DEFAULT_ORDER="XYZ";var mo=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},ib=0,sm=new G,Kr=new ui,hs=new at,_l=new G,ia=new G,sb=new G,rb=new ui,rm=new G(1,0,0),om=new G(0,1,0),am=new G(0,0,1),lm={type:"added"},ob={type:"removed"},Jr={type:"childadded",child:null},Fh={type:"childremoved",child:null},Dn=class n extends Pi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:ib++}),this.uuid=Ao(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new G,t=new _s,i=new ui,s=new G(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new at},normalMatrix:{value:new et}}),this.matrix=new at,this.matrixWorld=new at,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new mo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Kr.setFromAxisAngle(e,t),this.quaternion.multiply(Kr),this}rotateOnWorldAxis(e,t){return Kr.setFromAxisAngle(e,t),this.quaternion.premultiply(Kr),this}rotateX(e){return this.rotateOnAxis(rm,e)}rotateY(e){return this.rotateOnAxis(om,e)}rotateZ(e){return this.rotateOnAxis(am,e)}translateOnAxis(e,t){return sm.copy(e).applyQuaternion(this.quaternion),this.position.add(sm.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(rm,e)}translateY(e){return this.translateOnAxis(om,e)}translateZ(e){return this.translateOnAxis(am,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(hs.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?_l.copy(e):_l.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),ia.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?hs.lookAt(ia,_l,this.up):hs.lookAt(_l,ia,this.up),this.quaternion.setFromRotationMatrix(hs),s&&(hs.extractRotation(s.matrixWorld),Kr.setFromRotationMatrix(hs),this.quaternion.premultiply(Kr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Qe("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(lm),Jr.child=e,this.dispatchEvent(Jr),Jr.child=null):Qe("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(ob),Fh.child=e,this.dispatchEvent(Fh),Fh.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),hs.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),hs.multiply(e.parent.matrixWorld)),e.applyMatrix4(hs),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(lm),Jr.child=e,this.dispatchEvent(Jr),Jr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ia,e,sb),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ia,rb,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),d=o(e.skeletons),f=o(e.animations),p=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Dn.DEFAULT_UP=new G(0,1,0);Dn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Dn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Bn=class extends Dn{constructor(){super(),this.isGroup=!0,this.type="Group"}},ab={type:"move"},go=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Bn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Bn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new G,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new G),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Bn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new G,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new G,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let x of e.hand.values()){let g=t.getJointPose(x,i),m=this._getHandJoint(c,x);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(ab)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Bn;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},pg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Bs={h:0,s:0,l:0},yl={h:0,s:0,l:0};function Bh(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var $e=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=li){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,xt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=xt.workingColorSpace){return this.r=e,this.g=t,this.b=i,xt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=xt.workingColorSpace){if(e=Ud(e,1),t=pt(t,0,1),i=pt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=Bh(o,r,e+1/3),this.g=Bh(o,r,e),this.b=Bh(o,r,e-1/3)}return xt.colorSpaceToWorking(this,s),this}setStyle(e,t=li){function i(r){r!==void 0&&parseFloat(r)<1&&qe("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:qe("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);qe("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=li){let i=pg[e.toLowerCase()];return i!==void 0?this.setHex(i,t):qe("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=gs(e.r),this.g=gs(e.g),this.b=gs(e.b),this}copyLinearToSRGB(e){return this.r=lo(e.r),this.g=lo(e.g),this.b=lo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=li){return xt.workingToColorSpace(Fn.copy(this),e),Math.round(pt(Fn.r*255,0,255))*65536+Math.round(pt(Fn.g*255,0,255))*256+Math.round(pt(Fn.b*255,0,255))}getHexString(e=li){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=xt.workingColorSpace){xt.workingToColorSpace(Fn.copy(this),t);let i=Fn.r,s=Fn.g,r=Fn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=xt.workingColorSpace){return xt.workingToColorSpace(Fn.copy(this),t),e.r=Fn.r,e.g=Fn.g,e.b=Fn.b,e}getStyle(e=li){xt.workingToColorSpace(Fn.copy(this),e);let t=Fn.r,i=Fn.g,s=Fn.b;return e!==li?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Bs),this.setHSL(Bs.h+e,Bs.s+t,Bs.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Bs),e.getHSL(yl);let i=da(Bs.h,yl.h,t),s=da(Bs.s,yl.s,t),r=da(Bs.l,yl.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Fn=new $e;$e.NAMES=pg;var _a=class extends Dn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new _s,this.environmentIntensity=1,this.environmentRotation=new _s,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Ci=new G,ds=new G,zh=new G,fs=new G,jr=new G,Qr=new G,cm=new G,Vh=new G,Gh=new G,Hh=new G,Wh=new Ft,$h=new Ft,Xh=new Ft,Zi=class n{constructor(e=new G,t=new G,i=new G){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Ci.subVectors(e,t),s.cross(Ci);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Ci.subVectors(s,t),ds.subVectors(i,t),zh.subVectors(e,t);let o=Ci.dot(Ci),a=Ci.dot(ds),l=Ci.dot(zh),c=ds.dot(ds),u=ds.dot(zh),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,p=(o*u-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,fs)===null?!1:fs.x>=0&&fs.y>=0&&fs.x+fs.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,fs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,fs.x),l.addScaledVector(o,fs.y),l.addScaledVector(a,fs.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return Wh.setScalar(0),$h.setScalar(0),Xh.setScalar(0),Wh.fromBufferAttribute(e,t),$h.fromBufferAttribute(e,i),Xh.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Wh,r.x),o.addScaledVector($h,r.y),o.addScaledVector(Xh,r.z),o}static isFrontFacing(e,t,i,s){return Ci.subVectors(i,t),ds.subVectors(e,t),Ci.cross(ds).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ci.subVectors(this.c,this.b),ds.subVectors(this.a,this.b),Ci.cross(ds).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;jr.subVectors(s,i),Qr.subVectors(r,i),Vh.subVectors(e,i);let l=jr.dot(Vh),c=Qr.dot(Vh);if(l<=0&&c<=0)return t.copy(i);Gh.subVectors(e,s);let u=jr.dot(Gh),h=Qr.dot(Gh);if(u>=0&&h<=u)return t.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(jr,o);Hh.subVectors(e,r);let f=jr.dot(Hh),p=Qr.dot(Hh);if(p>=0&&f<=p)return t.copy(r);let x=f*c-l*p;if(x<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(i).addScaledVector(Qr,a);let g=u*p-f*h;if(g<=0&&h-u>=0&&f-p>=0)return cm.subVectors(r,s),a=(h-u)/(h-u+(f-p)),t.copy(s).addScaledVector(cm,a);let m=1/(g+x+d);return o=x*m,a=d*m,t.copy(i).addScaledVector(jr,o).addScaledVector(Qr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Ji=class{constructor(e=new G(1/0,1/0,1/0),t=new G(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Ri.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Ri.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Ri.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Ri):Ri.fromBufferAttribute(r,o),Ri.applyMatrix4(e.matrixWorld),this.expandByPoint(Ri);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),vl.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),vl.copy(i.boundingBox)),vl.applyMatrix4(e.matrixWorld),this.union(vl)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ri),Ri.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(sa),bl.subVectors(this.max,sa),eo.subVectors(e.a,sa),to.subVectors(e.b,sa),no.subVectors(e.c,sa),zs.subVectors(to,eo),Vs.subVectors(no,to),gr.subVectors(eo,no);let t=[0,-zs.z,zs.y,0,-Vs.z,Vs.y,0,-gr.z,gr.y,zs.z,0,-zs.x,Vs.z,0,-Vs.x,gr.z,0,-gr.x,-zs.y,zs.x,0,-Vs.y,Vs.x,0,-gr.y,gr.x,0];return!qh(t,eo,to,no,bl)||(t=[1,0,0,0,1,0,0,0,1],!qh(t,eo,to,no,bl))?!1:(Sl.crossVectors(zs,Vs),t=[Sl.x,Sl.y,Sl.z],qh(t,eo,to,no,bl))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ri).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ri).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(ps[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),ps[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),ps[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),ps[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),ps[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),ps[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),ps[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),ps[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(ps),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},ps=[new G,new G,new G,new G,new G,new G,new G,new G],Ri=new G,vl=new Ji,eo=new G,to=new G,no=new G,zs=new G,Vs=new G,gr=new G,sa=new G,bl=new G,Sl=new G,xr=new G;function qh(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){xr.fromArray(n,r);let a=s.x*Math.abs(xr.x)+s.y*Math.abs(xr.y)+s.z*Math.abs(xr.z),l=e.dot(xr),c=t.dot(xr),u=i.dot(xr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var mn=new G,Ml=new Ye,lb=0,an=class extends Pi{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:lb++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=ag,this.updateRanges=[],this.gpuType=bi,this.version=0,this._normalizationScale=e!==void 0?Fd(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Ml.fromBufferAttribute(this,t),Ml.applyMatrix3(e),this.setXY(t,Ml.x,Ml.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)mn.fromBufferAttribute(this,t),mn.applyMatrix3(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)mn.fromBufferAttribute(this,t),mn.applyMatrix4(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)mn.fromBufferAttribute(this,t),mn.applyNormalMatrix(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)mn.fromBufferAttribute(this,t),mn.transformDirection(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):dg(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):fg(e,this.array)}};var ya=class extends an{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var va=class extends an{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var sn=class extends an{constructor(e,t,i){super(new Float32Array(e),t,i)}},cb=new Ji,ra=new G,Yh=new G,ys=class{constructor(e=new G,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):cb.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;ra.subVectors(e,this.center);let t=ra.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(ra,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Yh.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(ra.copy(e.center).add(Yh)),this.expandByPoint(ra.copy(e.center).sub(Yh))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},ub=0,yi=new at,Zh=new Dn,io=new G,ai=new Ji,oa=new Ji,Pn=new G,yn=class n extends Pi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:ub++}),this.uuid=Ao(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Ov(e)?va:ya)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new et().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return yi.makeRotationFromQuaternion(e),this.applyMatrix4(yi),this}rotateX(e){return yi.makeRotationX(e),this.applyMatrix4(yi),this}rotateY(e){return yi.makeRotationY(e),this.applyMatrix4(yi),this}rotateZ(e){return yi.makeRotationZ(e),this.applyMatrix4(yi),this}translate(e,t,i){return yi.makeTranslation(e,t,i),this.applyMatrix4(yi),this}scale(e,t,i){return yi.makeScale(e,t,i),this.applyMatrix4(yi),this}lookAt(e){return Zh.lookAt(e),Zh.updateMatrix(),this.applyMatrix4(Zh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(io).negate(),this.translate(io.x,io.y,io.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new sn(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&qe("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ji);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Qe("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new G(-1/0,-1/0,-1/0),new G(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];ai.setFromBufferAttribute(r),this.morphTargetsRelative?(Pn.addVectors(this.boundingBox.min,ai.min),this.boundingBox.expandByPoint(Pn),Pn.addVectors(this.boundingBox.max,ai.max),this.boundingBox.expandByPoint(Pn)):(this.boundingBox.expandByPoint(ai.min),this.boundingBox.expandByPoint(ai.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Qe('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ys);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Qe("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new G,1/0);return}if(e){let i=this.boundingSphere.center;if(ai.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];oa.setFromBufferAttribute(a),this.morphTargetsRelative?(Pn.addVectors(ai.min,oa.min),ai.expandByPoint(Pn),Pn.addVectors(ai.max,oa.max),ai.expandByPoint(Pn)):(ai.expandByPoint(oa.min),ai.expandByPoint(oa.max))}ai.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Pn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Pn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Pn.fromBufferAttribute(a,c),l&&(io.fromBufferAttribute(e,c),Pn.add(io)),s=Math.max(s,i.distanceToSquared(Pn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Qe('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Qe("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new an(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let I=0;I<i.count;I++)a[I]=new G,l[I]=new G;let u=new G,h=new G,d=new G,f=new Ye,p=new Ye,x=new Ye,g=new G,m=new G;function _(I,L,C){c[I]=c[L]=c[C]=1,u.fromBufferAttribute(i,I),h.fromBufferAttribute(i,L),d.fromBufferAttribute(i,C),f.fromBufferAttribute(r,I),p.fromBufferAttribute(r,L),x.fromBufferAttribute(r,C),h.sub(u),d.sub(u),p.sub(f),x.sub(f);let D=1/(p.x*x.y-x.x*p.y);isFinite(D)&&(g.copy(h).multiplyScalar(x.y).addScaledVector(d,-p.y).multiplyScalar(D),m.copy(d).multiplyScalar(p.x).addScaledVector(h,-x.x).multiplyScalar(D),a[I].add(g),a[L].add(g),a[C].add(g),l[I].add(m),l[L].add(m),l[C].add(m))}let b=this.groups;b.length===0&&(b=[{start:0,count:e.count}]);for(let I=0,L=b.length;I<L;++I){let C=b[I],D=C.start,k=C.count;for(let N=D,B=D+k;N<B;N+=3)_(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let v=new G,E=new G,A=new G,y=new G;function M(I){A.fromBufferAttribute(s,I),y.copy(A);let L=a[I];v.copy(L),v.sub(A.multiplyScalar(A.dot(L))).normalize(),E.crossVectors(y,L);let D=E.dot(l[I])<0?-1:1;o.setXYZW(I,v.x,v.y,v.z,D)}for(let I=0,L=i.count;I<L;++I)c[I]&&M(I);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new an(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new G,r=new G,o=new G,a=new G,l=new G,c=new G,u=new G,h=new G;if(e)for(let d=0,f=e.count;d<f;d+=3){let p=e.getX(d+0),x=e.getX(d+1),g=e.getX(d+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,x),o.fromBufferAttribute(t,g),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,g),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Pn.fromBufferAttribute(e,t),Pn.normalize(),e.setXYZ(t,Pn.x,Pn.y,Pn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,p=0;for(let x=0,g=l.length;x<g;x++){a.isInterleavedBufferAttribute?f=l[x]*a.data.stride+a.offset:f=l[x]*u;for(let m=0;m<u;m++)d[p++]=c[f++]}return new an(d,u,h)}if(this.index===null)return qe("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=e(d,i);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Kh=new G,hb=new G,db=new et,ci=class{constructor(e=new G(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=Kh.subVectors(i,t).cross(hb.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(Kh),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||db.getNormalMatrix(e),s=this.coplanarPoint(Kh).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},fb=0,vs=class extends Pi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:fb++}),this.uuid=Ao(),this.name="",this.type="Material",this.blending=So,this.side=Js,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=fd,this.blendDst=pd,this.blendEquation=wr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new $e(0,0,0),this.blendAlpha=0,this.depthFunc=co,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=tg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Vl,this.stencilZFail=Vl,this.stencilZPass=Vl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){qe(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){qe(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new $e().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new ci().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Ye().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ye().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var ms=new G,Jh=new G,wl=new G,Al=new G,Hs=class{constructor(e=new G,t=new G(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ms)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ms.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ms.copy(this.origin).addScaledVector(this.direction,t),ms.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Jh.copy(e).add(t).multiplyScalar(.5),wl.copy(t).sub(e).normalize(),Al.copy(this.origin).sub(Jh);let r=e.distanceTo(t)*.5,o=-this.direction.dot(wl),a=Al.dot(this.direction),l=-Al.dot(wl),c=Al.lengthSq(),u=Math.abs(1-o*o),h,d,f,p;if(u>0)if(h=o*l-a,d=o*a-l,p=r*u,h>=0)if(d>=-p)if(d<=p){let x=1/u;h*=x,d*=x,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-p?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=p?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Jh).addScaledVector(wl,d),f}intersectSphere(e,t){if(e.radius<0)return null;ms.subVectors(e.center,this.origin);let i=ms.dot(this.direction),s=ms.dot(ms)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(i=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),u>=0?(r=(e.min.y-d.y)*u,o=(e.max.y-d.y)*u):(r=(e.max.y-d.y)*u,o=(e.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-d.z)*h,l=(e.max.z-d.z)*h):(a=(e.max.z-d.z)*h,l=(e.min.z-d.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,ms)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,d=e.y-o.y,f=e.z-o.z,p=t.x-o.x,x=t.y-o.y,g=t.z-o.z,m=i.x-o.x,_=i.y-o.y,b=i.z-o.z,v=Math.abs(l),E=Math.abs(c),A=Math.abs(u),y,M,I,L,C,D,k,N,B,$,H,se;if(v>=E&&v>=A?(I=l,D=h,B=p,se=m,l>=0?(y=c,M=u,L=d,C=f,k=x,N=g,$=_,H=b):(y=u,M=c,L=f,C=d,k=g,N=x,$=b,H=_)):E>=A?(I=c,D=d,B=x,se=_,c>=0?(y=u,M=l,L=f,C=h,k=g,N=p,$=b,H=m):(y=l,M=u,L=h,C=f,k=p,N=g,$=m,H=b)):(I=u,D=f,B=g,se=b,u>=0?(y=l,M=c,L=h,C=d,k=p,N=x,$=m,H=_):(y=c,M=l,L=d,C=h,k=x,N=p,$=_,H=m)),I===0)return null;let Y=y/I,Q=M/I,ie=1/I,fe=L-Y*D,de=C-Q*D,ee=k-Y*B,he=N-Q*B,ge=$-Y*se,Se=H-Q*se,Me=ge*he-Se*ee,He=fe*Se-de*ge,st=ee*de-he*fe;if(s){if(Me<0||He<0||st<0)return null}else if((Me<0||He<0||st<0)&&(Me>0||He>0||st>0))return null;let Ve=Me+He+st;if(Ve===0)return null;let ht=ie*(Me*D+He*B+st*se);return(Ve>0?ht<0:ht>0)?null:this.at(ht/Ve,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},vr=class extends vs{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new $e(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new _s,this.combine=vc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},um=new at,_r=new Hs,El=new ys,hm=new G,Tl=new G,Cl=new G,Rl=new G,jh=new G,Pl=new G,dm=new G,Il=new G,On=class extends Dn{constructor(e=new yn,t=new vr){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Pl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(jh.fromBufferAttribute(h,e),o?Pl.addScaledVector(jh,u):Pl.addScaledVector(jh.sub(t),u))}t.add(Pl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),El.copy(i.boundingSphere),El.applyMatrix4(r),_r.copy(e.ray).recast(e.near),!(El.containsPoint(_r.origin)===!1&&(_r.intersectSphere(El,hm)===null||_r.origin.distanceToSquared(hm)>(e.far-e.near)**2))&&(um.copy(r).invert(),_r.copy(e.ray).applyMatrix4(um),!(i.boundingBox!==null&&_r.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,_r)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let g=d[p],m=o[g.materialIndex],_=Math.max(g.start,f.start),b=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let v=_,E=b;v<E;v+=3){let A=a.getX(v),y=a.getX(v+1),M=a.getX(v+2);s=Ll(this,m,e,i,c,u,h,A,y,M),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let g=p,m=x;g<m;g+=3){let _=a.getX(g),b=a.getX(g+1),v=a.getX(g+2);s=Ll(this,o,e,i,c,u,h,_,b,v),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let g=d[p],m=o[g.materialIndex],_=Math.max(g.start,f.start),b=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let v=_,E=b;v<E;v+=3){let A=v,y=v+1,M=v+2;s=Ll(this,m,e,i,c,u,h,A,y,M),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(l.count,f.start+f.count);for(let g=p,m=x;g<m;g+=3){let _=g,b=g+1,v=g+2;s=Ll(this,o,e,i,c,u,h,_,b,v),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function pb(n,e,t,i,s,r,o,a){let l;if(e.side===Kn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===Js,a),l===null)return null;Il.copy(a),Il.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Il);return c<t.near||c>t.far?null:{distance:c,point:Il.clone(),object:n}}function Ll(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,Tl),n.getVertexPosition(l,Cl),n.getVertexPosition(c,Rl);let u=pb(n,e,t,i,Tl,Cl,Rl,dm);if(u){let h=new G;Zi.getBarycoord(dm,Tl,Cl,Rl,h),s&&(u.uv=Zi.getInterpolatedAttribute(s,a,l,c,h,new Ye)),r&&(u.uv1=Zi.getInterpolatedAttribute(r,a,l,c,h,new Ye)),o&&(u.normal=Zi.getInterpolatedAttribute(o,a,l,c,h,new G),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new G,materialIndex:0};Zi.getNormal(Tl,Cl,Rl,d.normal),u.face=d,u.barycoord=h}return u}var ba=class extends Qn{constructor(e=null,t=1,i=1,s,r,o,a,l,c=In,u=In,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Sa=class extends an{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},so=new at,fm=new at,Nl=[],pm=new Ji,mb=new at,aa=new On,la=new ys,di=class extends On{constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Sa(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,mb)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new Ji),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,so),pm.copy(e.boundingBox).applyMatrix4(so),this.boundingBox.union(pm)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new ys),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,so),la.copy(e.boundingSphere).applyMatrix4(so),this.boundingSphere.union(la)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let i=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=e*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(e,t){let i=this.matrixWorld,s=this.count;if(aa.geometry=this.geometry,aa.material=this.material,aa.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),la.copy(this.boundingSphere),la.applyMatrix4(i),e.ray.intersectsSphere(la)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,so),fm.multiplyMatrices(i,so),aa.matrixWorld=fm,aa.raycast(e,Nl);for(let o=0,a=Nl.length;o<a;o++){let l=Nl[o];l.instanceId=r,l.object=this,t.push(l)}Nl.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Sa(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let i=t.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new ba(new Float32Array(s*this.count),s,this.count,Tc,bi));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},yr=new ys,gb=new Ye(.5,.5),Dl=new G,Ws=class{constructor(e=new ci,t=new ci,i=new ci,s=new ci,r=new ci,o=new ci){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=vi,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],p=r[8],x=r[9],g=r[10],m=r[11],_=r[12],b=r[13],v=r[14],E=r[15];if(s[0].setComponents(c-o,f-u,m-p,E-_).normalize(),s[1].setComponents(c+o,f+u,m+p,E+_).normalize(),s[2].setComponents(c+a,f+h,m+x,E+b).normalize(),s[3].setComponents(c-a,f-h,m-x,E-b).normalize(),i)s[4].setComponents(l,d,g,v).normalize(),s[5].setComponents(c-l,f-d,m-g,E-v).normalize();else if(s[4].setComponents(c-l,f-d,m-g,E-v).normalize(),t===vi)s[5].setComponents(c+l,f+d,m+g,E+v).normalize();else if(t===uo)s[5].setComponents(l,d,g,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),yr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),yr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(yr)}intersectsSprite(e){yr.center.set(0,0,0);let t=gb.distanceTo(e.center);return yr.radius=.7071067811865476+t,yr.applyMatrix4(e.matrixWorld),this.intersectsSphere(yr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(Dl.x=s.normal.x>0?e.max.x:e.min.x,Dl.y=s.normal.y>0?e.max.y:e.min.y,Dl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Dl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},mm=new at,tc=class n{constructor(){this.coordinateSystem=vi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];mm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Ws),i[s].setFromProjectionMatrix(mm,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Ws),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var $s=class extends vs{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new $e(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},nc=new G,ic=new G,gm=new at,ca=new Hs,Ol=new ys,Qh=new G,xm=new G,sc=class extends Dn{constructor(e=new yn,t=new $s){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)nc.fromBufferAttribute(t,s-1),ic.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=nc.distanceTo(ic);e.setAttribute("lineDistance",new sn(i,1))}else qe("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Ol.copy(i.boundingSphere),Ol.applyMatrix4(s),Ol.radius+=r,e.ray.intersectsSphere(Ol)===!1)return;gm.copy(s).invert(),ca.copy(e.ray).applyMatrix4(gm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let x=f,g=p-1;x<g;x+=c){let m=u.getX(x),_=u.getX(x+1),b=Ul(this,e,ca,l,m,_,x);b&&t.push(b)}if(this.isLineLoop){let x=u.getX(p-1),g=u.getX(f),m=Ul(this,e,ca,l,x,g,p-1);m&&t.push(m)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let x=f,g=p-1;x<g;x+=c){let m=Ul(this,e,ca,l,x,x+1,x);m&&t.push(m)}if(this.isLineLoop){let x=Ul(this,e,ca,l,p-1,f,p-1);x&&t.push(x)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Ul(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(nc.fromBufferAttribute(a,s),ic.fromBufferAttribute(a,r),t.distanceSqToSegment(nc,ic,Qh,xm)>i)return;Qh.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Qh);if(!(c<e.near||c>e.far))return{distance:c,point:xm.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var _m=new G,ym=new G,br=class extends sc{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)_m.fromBufferAttribute(t,s),ym.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+_m.distanceTo(ym);e.setAttribute("lineDistance",new sn(i,1))}else qe("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ma=class extends Qn{constructor(e=[],t=Ar,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var bs=class extends Qn{constructor(e,t,i=Ii,s,r,o,a=In,l=In,c,u=xs,h=1){if(u!==xs&&u!==ws)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:h};super(d,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new po(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},wa=class extends bs{constructor(e,t=Ii,i=Ar,s,r,o=In,a=In,l,c=xs){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Aa=class extends Qn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},xo=class n extends yn{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;p("z","y","x",-1,-1,i,t,e,o,r,0),p("z","y","x",1,-1,i,t,-e,o,r,1),p("x","z","y",1,1,e,i,t,s,o,2),p("x","z","y",1,-1,e,i,-t,s,o,3),p("x","y","z",1,-1,e,t,i,s,r,4),p("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new sn(c,3)),this.setAttribute("normal",new sn(u,3)),this.setAttribute("uv",new sn(h,2));function p(x,g,m,_,b,v,E,A,y,M,I){let L=v/y,C=E/M,D=v/2,k=E/2,N=A/2,B=y+1,$=M+1,H=0,se=0,Y=new G;for(let Q=0;Q<$;Q++){let ie=Q*C-k;for(let fe=0;fe<B;fe++){let de=fe*L-D;Y[x]=de*_,Y[g]=ie*b,Y[m]=N,c.push(Y.x,Y.y,Y.z),Y[x]=0,Y[g]=0,Y[m]=A>0?1:-1,u.push(Y.x,Y.y,Y.z),h.push(fe/y),h.push(1-Q/M),H+=1}}for(let Q=0;Q<M;Q++)for(let ie=0;ie<y;ie++){let fe=d+ie+B*Q,de=d+ie+B*(Q+1),ee=d+(ie+1)+B*(Q+1),he=d+(ie+1)+B*Q;l.push(fe,de,he),l.push(de,ee,he),se+=6}a.addGroup(f,se,I),f+=se,d+=H}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var ji=class n extends yn{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],p=0,x=[],g=i/2,m=0;_(),o===!1&&(e>0&&b(!0),t>0&&b(!1)),this.setIndex(u),this.setAttribute("position",new sn(h,3)),this.setAttribute("normal",new sn(d,3)),this.setAttribute("uv",new sn(f,2));function _(){let v=new G,E=new G,A=0,y=(t-e)/i;for(let M=0;M<=r;M++){let I=[],L=M/r,C=L*(t-e)+e;for(let D=0;D<=s;D++){let k=D/s,N=k*l+a,B=Math.sin(N),$=Math.cos(N);E.x=C*B,E.y=-L*i+g,E.z=C*$,h.push(E.x,E.y,E.z),v.set(B,y,$).normalize(),d.push(v.x,v.y,v.z),f.push(k,1-L),I.push(p++)}x.push(I)}for(let M=0;M<s;M++)for(let I=0;I<r;I++){let L=x[I][M],C=x[I+1][M],D=x[I+1][M+1],k=x[I][M+1];(e>0||I!==0)&&(u.push(L,C,k),A+=3),(t>0||I!==r-1)&&(u.push(C,D,k),A+=3)}c.addGroup(m,A,0),m+=A}function b(v){let E=p,A=new Ye,y=new G,M=0,I=v===!0?e:t,L=v===!0?1:-1;for(let D=1;D<=s;D++)h.push(0,g*L,0),d.push(0,L,0),f.push(.5,.5),p++;let C=p;for(let D=0;D<=s;D++){let N=D/s*l+a,B=Math.cos(N),$=Math.sin(N);y.x=I*$,y.y=g*L,y.z=I*B,h.push(y.x,y.y,y.z),d.push(0,L,0),A.x=B*.5+.5,A.y=$*.5*L+.5,f.push(A.x,A.y),p++}for(let D=0;D<s;D++){let k=E+D,N=C+D;v===!0?u.push(N,N+1,k):u.push(N+1,N,k),M+=3}c.addGroup(m,M,v===!0?1:2),m+=M}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Ea=class n extends ji{constructor(e=1,t=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Ta=class n extends yn{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=e/a,d=t/l,f=[],p=[],x=[],g=[];for(let m=0;m<u;m++){let _=m*d-o;for(let b=0;b<c;b++){let v=b*h-r;p.push(v,-_,0),x.push(0,0,1),g.push(b/a),g.push(1-m/l)}}for(let m=0;m<l;m++)for(let _=0;_<a;_++){let b=_+c*m,v=_+c*(m+1),E=_+1+c*(m+1),A=_+1+c*m;f.push(b,v,A),f.push(v,E,A)}this.setIndex(f),this.setAttribute("position",new sn(p,3)),this.setAttribute("normal",new sn(x,3)),this.setAttribute("uv",new sn(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var _o=class n extends yn{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new G,d=new G,f=[],p=[],x=[],g=[];for(let m=0;m<=i;m++){let _=[],b=m/i,v=o+b*a,E=e*Math.cos(v),A=Math.sqrt(e*e-E*E),y=0;m===0&&o===0?y=.5/t:m===i&&l===Math.PI&&(y=-.5/t);for(let M=0;M<=t;M++){let I=M/t,L=s+I*r;h.x=-A*Math.cos(L),h.y=E,h.z=A*Math.sin(L),p.push(h.x,h.y,h.z),d.copy(h).normalize(),x.push(d.x,d.y,d.z),g.push(I+y,1-b),_.push(c++)}u.push(_)}for(let m=0;m<i;m++)for(let _=0;_<t;_++){let b=u[m][_+1],v=u[m][_],E=u[m+1][_],A=u[m+1][_+1];(m!==0||o>0)&&f.push(b,v,A),(m!==i-1||l<Math.PI)&&f.push(v,E,A)}this.setIndex(f),this.setAttribute("position",new sn(p,3)),this.setAttribute("normal",new sn(x,3)),this.setAttribute("uv",new sn(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function Tr(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(vm(s))s.isRenderTargetTexture?(qe("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(vm(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function Vn(n){let e={};for(let t=0;t<n.length;t++){let i=Tr(n[t]);for(let s in i)e[s]=i[s]}return e}function vm(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function xb(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function zd(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:xt.workingColorSpace}var mg={clone:Tr,merge:Vn},_b=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,yb=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Qi=class extends vs{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=_b,this.fragmentShader=yb,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Tr(e.uniforms),this.uniformsGroups=xb(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new $e().setHex(s.value);break;case"v2":this.uniforms[i].value=new Ye().fromArray(s.value);break;case"v3":this.uniforms[i].value=new G().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Ft().fromArray(s.value);break;case"m3":this.uniforms[i].value=new et().fromArray(s.value);break;case"m4":this.uniforms[i].value=new at().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},rc=class extends Qi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ss=class extends vs{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new $e(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new $e(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=au,this.normalScale=new Ye(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new _s,this.combine=vc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},oc=class extends vs{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Qm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},ac=class extends vs{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function ro(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function kl(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Xs=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break e}o=i,i=0;break t}break n}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},lc=class extends Xs{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:nd,endingEnd:nd}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case id:r=e,a=2*t-i;break;case sd:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case id:o=e,l=2*i-t;break;case sd:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(i-t)/(s-t),x=p*p,g=x*p,m=-d*g+2*d*x-d*p,_=(1+d)*g+(-1.5-2*d)*x+(-.5+d)*p+1,b=(-1-f)*g+(1.5+f)*x+.5*p,v=f*g-f*x;for(let E=0;E!==a;++E)r[E]=m*o[u+E]+_*o[c+E]+b*o[l+E]+v*o[h+E];return r}},cc=class extends Xs{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},uc=class extends Xs{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},hc=class extends Xs{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let p=(i-t)/(s-t),x=1-p;for(let g=0;g!==a;++g)r[g]=o[c+g]*x+o[l+g]*p;return r}let d=a*2,f=e-1;for(let p=0;p!==a;++p){let x=o[c+p],g=o[l+p],m=f*d+p*2,_=h[m],b=h[m+1],v=e*d+p*2,E=u[v],A=u[v+1],y=bb(i,t,_,E,s);r[p]=gg(y,x,b,A,g)}return r}};function gg(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function vb(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function bb(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=gg(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=vb(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var fi=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=ro(t,this.TimeBufferType),this.values=ro(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:ro(e.times,Array),values:ro(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),kl(e.settings)&&(i.settings={inTangents:ro(e.settings.inTangents,Array),outTangents:ro(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new uc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new cc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new lc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new hc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case fa:t=this.InterpolantFactoryMethodDiscrete;break;case Jl:t=this.InterpolantFactoryMethodLinear;break;case zl:t=this.InterpolantFactoryMethodSmooth;break;case td:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return qe("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return fa;case this.InterpolantFactoryMethodLinear:return Jl;case this.InterpolantFactoryMethodSmooth:return zl;case this.InterpolantFactoryMethodBezier:return td}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;kl(this.settings)&&(bm(this.settings.inTangents,e),bm(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;kl(this.settings)&&(Sm(this.settings.inTangents,e),Sm(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Qe("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(Qe("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){Qe("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){Qe("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&Uv(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Qe("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===zl,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*i,d=h-i,f=h+i;for(let p=0;p!==i;++p){let x=t[h+p];if(x!==t[d+p]||x!==t[f+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)t[d+f]=t[h+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,kl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function bm(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function Sm(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}fi.prototype.ValueTypeName="";fi.prototype.TimeBufferType=Float32Array;fi.prototype.ValueBufferType=Float32Array;fi.prototype.DefaultInterpolation=Jl;var qs=class extends fi{constructor(e,t,i){super(e,t,i)}};qs.prototype.ValueTypeName="bool";qs.prototype.ValueBufferType=Array;qs.prototype.DefaultInterpolation=fa;qs.prototype.InterpolantFactoryMethodLinear=void 0;qs.prototype.InterpolantFactoryMethodSmooth=void 0;var dc=class extends fi{constructor(e,t,i,s){super(e,t,i,s)}};dc.prototype.ValueTypeName="color";var fc=class extends fi{constructor(e,t,i,s){super(e,t,i,s)}};fc.prototype.ValueTypeName="number";var pc=class extends Xs{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)ui.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ca=class extends fi{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new pc(this.times,this.values,this.getValueSize(),e)}};Ca.prototype.ValueTypeName="quaternion";Ca.prototype.InterpolantFactoryMethodSmooth=void 0;var Ys=class extends fi{constructor(e,t,i){super(e,t,i)}};Ys.prototype.ValueTypeName="string";Ys.prototype.ValueBufferType=Array;Ys.prototype.DefaultInterpolation=fa;Ys.prototype.InterpolantFactoryMethodLinear=void 0;Ys.prototype.InterpolantFactoryMethodSmooth=void 0;var mc=class extends fi{constructor(e,t,i,s){super(e,t,i,s)}};mc.prototype.ValueTypeName="vector";var gc=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],p=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},xg=new gc,xc=class{constructor(e){this.manager=e!==void 0?e:xg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};xc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ra=class extends Dn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new $e(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},Pa=class extends Ra{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Dn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new $e(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},ed=new at,Mm=new G,wm=new G,_c=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ye(512,512),this.mapType=ei,this.map=null,this.mapPass=null,this.matrix=new at,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Ws,this._frameExtents=new Ye(1,1),this._viewportCount=1,this._viewports=[new Ft(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;Mm.setFromMatrixPosition(e.matrixWorld),t.position.copy(Mm),wm.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(wm),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){ed.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(ed,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===uo||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(ed)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Fl=new G,Bl=new ui,Yi=new G,Ia=class extends Dn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new at,this.projectionMatrix=new at,this.projectionMatrixInverse=new at,this.coordinateSystem=vi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Fl,Bl,Yi),Yi.x===1&&Yi.y===1&&Yi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Fl,Bl,Yi.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Fl,Bl,Yi),Yi.x===1&&Yi.y===1&&Yi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Fl,Bl,Yi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Gs=new G,Am=new Ye,Em=new Ye,Yn=class extends Ia{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=fo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(ha*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return fo*2*Math.atan(Math.tan(ha*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Gs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Gs.x,Gs.y).multiplyScalar(-e/Gs.z),Gs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Gs.x,Gs.y).multiplyScalar(-e/Gs.z)}getViewSize(e,t){return this.getViewBounds(e,Am,Em),t.subVectors(Em,Am)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(ha*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var La=class extends Ia{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},rd=class extends _c{constructor(){super(new La(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Na=class extends Ra{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Dn.DEFAULT_UP),this.updateMatrix(),this.target=new Dn,this.shadow=new rd}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var oo=-90,ao=1,yo=class extends Dn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Yn(oo,ao,e,t);s.layers=this.layers,this.add(s);let r=new Yn(oo,ao,e,t);r.layers=this.layers,this.add(r);let o=new Yn(oo,ao,e,t);o.layers=this.layers,this.add(o);let a=new Yn(oo,ao,e,t);a.layers=this.layers,this.add(a);let l=new Yn(oo,ao,e,t);l.layers=this.layers,this.add(l);let c=new Yn(oo,ao,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===vi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===uo)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=x,e.setRenderTarget(i,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,d,f),e.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},yc=class extends Yn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Vd="\\[\\]\\.:\\/",Sb=new RegExp("["+Vd+"]","g"),Gd="[^"+Vd+"]",Mb="[^"+Vd.replace("\\.","")+"]",wb=/((?:WC+[\/:])*)/.source.replace("WC",Gd),Ab=/(WCOD+)?/.source.replace("WCOD",Mb),Eb=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Gd),Tb=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Gd),Cb=new RegExp("^"+wb+Ab+Eb+Tb+"$"),Rb=["material","materials","bones","map"],od=class{constructor(e,t,i){let s=i||Xt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Xt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Sb,"")}static parseTrackName(e){let t=Cb.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);Rb.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){qe("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){Qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Qe("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Qe("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Qe("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){Qe("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){Qe("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;Qe("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Xt.Composite=od;Xt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Xt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Xt.prototype.GetterByBindingType=[Xt.prototype._getValue_direct,Xt.prototype._getValue_array,Xt.prototype._getValue_arrayElement,Xt.prototype._getValue_toArray];Xt.prototype.SetterByBindingTypeAndVersioning=[[Xt.prototype._setValue_direct,Xt.prototype._setValue_direct_setNeedsUpdate,Xt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Xt.prototype._setValue_array,Xt.prototype._setValue_array_setNeedsUpdate,Xt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Xt.prototype._setValue_arrayElement,Xt.prototype._setValue_arrayElement_setNeedsUpdate,Xt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Xt.prototype._setValue_fromArray,Xt.prototype._setValue_fromArray_setNeedsUpdate,Xt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var NI=new Float32Array(1);var Tm=new at,Sr=class{constructor(e,t,i=0,s=1/0){this.ray=new Hs(e,t),this.near=i,this.far=s,this.camera=null,this.layers=new mo,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):Qe("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Tm.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Tm),this}intersectObject(e,t=!0,i=[]){return ad(e,this,i,t),i.sort(Cm),i}intersectObjects(e,t=!0,i=[]){for(let s=0,r=e.length;s<r;s++)ad(e[s],this,i,t);return i.sort(Cm),i}};function Cm(n,e){return n.distance-e.distance}function ad(n,e,t,i){let s=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)ad(r[o],e,t,!0)}}var vo=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=pt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(pt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var ld=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var Da=class extends Pi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Hd(n,e,t,i){let s=Pb(i);switch(t){case Td:return n*e;case Tc:return n*e/s.components*s.byteLength;case Cc:return n*e/s.components*s.byteLength;case js:return n*e*2/s.components*s.byteLength;case Rc:return n*e*2/s.components*s.byteLength;case Cd:return n*e*3/s.components*s.byteLength;case Ni:return n*e*4/s.components*s.byteLength;case Pc:return n*e*4/s.components*s.byteLength;case ka:case Fa:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Ba:case za:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Lc:case Dc:return Math.max(n,16)*Math.max(e,8)/4;case Ic:case Nc:return Math.max(n,8)*Math.max(e,8)/2;case Oc:case Uc:case Fc:case Bc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case kc:case Va:case zc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Vc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Gc:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Hc:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Wc:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case $c:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Xc:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case qc:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Yc:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Zc:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Kc:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Jc:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case jc:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Qc:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case eu:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case tu:case nu:case iu:return Math.ceil(n/4)*Math.ceil(e/4)*16;case su:case ru:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Ga:case ou:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function Pb(n){switch(n){case ei:case Md:return{byteLength:1,components:1};case wo:case wd:case Li:return{byteLength:2,components:1};case Ac:case Ec:return{byteLength:2,components:4};case Ii:case wc:case bi:return{byteLength:4,components:1};case Ad:case Ed:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?qe("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Bg(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function Lb(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<h.length;f++){let p=h[d],x=h[f];x.start<=p.start+p.count+1?p.count=Math.max(p.count,x.start+x.count-p.start):(++d,h[d]=x)}h.length=d+1;for(let f=0,p=h.length;f<p;f++){let x=h[f];n.bufferSubData(c,x.start*u.BYTES_PER_ELEMENT,u,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Nb=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Db=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Ob=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Ub=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,kb=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Fb=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Bb=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,zb=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Vb=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,Gb=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Hb=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Wb=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,$b=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Xb=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,qb=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Yb=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Zb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Kb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Jb=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,jb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Qb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,eS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,tS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,nS=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,iS=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,sS=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,rS=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,oS=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,aS=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,lS="gl_FragColor = linearToOutputTexel( gl_FragColor );",cS=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,uS=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,hS=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,dS=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,fS=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,pS=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,mS=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,gS=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,xS=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,_S=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,yS=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,vS=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,bS=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,SS=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,MS=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,wS=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,AS=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,ES=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,TS=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,CS=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,RS=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,PS=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,IS=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,LS=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,NS=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,DS=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,OS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,US=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,kS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,FS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,BS=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,zS=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,VS=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,GS=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,HS=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,WS=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,$S=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,XS=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,qS=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,YS=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,ZS=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,KS=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,JS=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,jS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,QS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,eM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,tM=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,nM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,iM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,sM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,rM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,oM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,aM=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,lM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,cM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,uM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,hM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,dM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,fM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,pM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,mM=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,gM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,xM=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,_M=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,yM=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,vM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,bM=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,SM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,MM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,wM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,AM=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,EM=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,TM=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,CM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,RM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,PM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,IM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,LM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,NM=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,DM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,OM=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,UM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,kM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,FM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,BM=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,zM=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,VM=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,GM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,HM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,WM=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,$M=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,XM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,qM=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,YM=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,ZM=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,KM=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,JM=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,jM=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,QM=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,ew=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,tw=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,nw=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,iw=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,sw=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,rw=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ow=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,aw=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,lw=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,cw=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,uw=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,hw=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ut={alphahash_fragment:Nb,alphahash_pars_fragment:Db,alphamap_fragment:Ob,alphamap_pars_fragment:Ub,alphatest_fragment:kb,alphatest_pars_fragment:Fb,aomap_fragment:Bb,aomap_pars_fragment:zb,batching_pars_vertex:Vb,batching_vertex:Gb,begin_vertex:Hb,beginnormal_vertex:Wb,bsdfs:$b,iridescence_fragment:Xb,bumpmap_pars_fragment:qb,clipping_planes_fragment:Yb,clipping_planes_pars_fragment:Zb,clipping_planes_pars_vertex:Kb,clipping_planes_vertex:Jb,color_fragment:jb,color_pars_fragment:Qb,color_pars_vertex:eS,color_vertex:tS,common:nS,defaultnormal_vertex:iS,displacementmap_pars_vertex:sS,displacementmap_vertex:rS,emissivemap_fragment:oS,emissivemap_pars_fragment:aS,colorspace_fragment:lS,colorspace_pars_fragment:cS,envmap_fragment:uS,envmap_common_pars_fragment:hS,envmap_pars_fragment:dS,envmap_pars_vertex:fS,envmap_physical_pars_fragment:wS,envmap_vertex:pS,fog_vertex:mS,fog_pars_vertex:gS,fog_fragment:xS,fog_pars_fragment:_S,gradientmap_pars_fragment:yS,lightmap_pars_fragment:vS,lights_lambert_fragment:bS,lights_lambert_pars_fragment:SS,lights_pars_begin:MS,lights_toon_fragment:AS,lights_toon_pars_fragment:ES,lights_phong_fragment:TS,lights_phong_pars_fragment:CS,lights_physical_fragment:RS,lights_physical_pars_fragment:PS,lights_fragment_begin:IS,lights_fragment_maps:LS,lights_fragment_end:NS,lightprobes_pars_fragment:DS,logdepthbuf_fragment:OS,logdepthbuf_pars_fragment:US,logdepthbuf_pars_vertex:kS,logdepthbuf_vertex:FS,map_fragment:BS,map_pars_fragment:zS,map_particle_fragment:VS,map_particle_pars_fragment:GS,metalnessmap_fragment:HS,metalnessmap_pars_fragment:WS,morphinstance_vertex:$S,morphcolor_vertex:XS,morphnormal_vertex:qS,morphtarget_pars_vertex:YS,morphtarget_vertex:ZS,normal_fragment_begin:KS,normal_fragment_maps:JS,normal_pars_fragment:jS,normal_pars_vertex:QS,normal_vertex:eM,normalmap_pars_fragment:tM,clearcoat_normal_fragment_begin:nM,clearcoat_normal_fragment_maps:iM,clearcoat_pars_fragment:sM,iridescence_pars_fragment:rM,opaque_fragment:oM,packing:aM,premultiplied_alpha_fragment:lM,project_vertex:cM,dithering_fragment:uM,dithering_pars_fragment:hM,roughnessmap_fragment:dM,roughnessmap_pars_fragment:fM,shadowmap_pars_fragment:pM,shadowmap_pars_vertex:mM,shadowmap_vertex:gM,shadowmask_pars_fragment:xM,skinbase_vertex:_M,skinning_pars_vertex:yM,skinning_vertex:vM,skinnormal_vertex:bM,specularmap_fragment:SM,specularmap_pars_fragment:MM,tonemapping_fragment:wM,tonemapping_pars_fragment:AM,transmission_fragment:EM,transmission_pars_fragment:TM,uv_pars_fragment:CM,uv_pars_vertex:RM,uv_vertex:PM,worldpos_vertex:IM,background_vert:LM,background_frag:NM,backgroundCube_vert:DM,backgroundCube_frag:OM,cube_vert:UM,cube_frag:kM,depth_vert:FM,depth_frag:BM,distance_vert:zM,distance_frag:VM,equirect_vert:GM,equirect_frag:HM,linedashed_vert:WM,linedashed_frag:$M,meshbasic_vert:XM,meshbasic_frag:qM,meshlambert_vert:YM,meshlambert_frag:ZM,meshmatcap_vert:KM,meshmatcap_frag:JM,meshnormal_vert:jM,meshnormal_frag:QM,meshphong_vert:ew,meshphong_frag:tw,meshphysical_vert:nw,meshphysical_frag:iw,meshtoon_vert:sw,meshtoon_frag:rw,points_vert:ow,points_frag:aw,shadow_vert:lw,shadow_frag:cw,sprite_vert:uw,sprite_frag:hw},Le={common:{diffuse:{value:new $e(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new et}},envmap:{envMap:{value:null},envMapRotation:{value:new et},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new et}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new et}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new et},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new et},normalScale:{value:new Ye(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new et},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new et}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new et}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new et}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new $e(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new $e(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0},uvTransform:{value:new et}},sprite:{diffuse:{value:new $e(16777215)},opacity:{value:1},center:{value:new Ye(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}}},ns={basic:{uniforms:Vn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:ut.meshbasic_vert,fragmentShader:ut.meshbasic_frag},lambert:{uniforms:Vn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new $e(0)},envMapIntensity:{value:1}}]),vertexShader:ut.meshlambert_vert,fragmentShader:ut.meshlambert_frag},phong:{uniforms:Vn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new $e(0)},specular:{value:new $e(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ut.meshphong_vert,fragmentShader:ut.meshphong_frag},standard:{uniforms:Vn([Le.common,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new $e(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ut.meshphysical_vert,fragmentShader:ut.meshphysical_frag},toon:{uniforms:Vn([Le.common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new $e(0)}}]),vertexShader:ut.meshtoon_vert,fragmentShader:ut.meshtoon_frag},matcap:{uniforms:Vn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:ut.meshmatcap_vert,fragmentShader:ut.meshmatcap_frag},points:{uniforms:Vn([Le.points,Le.fog]),vertexShader:ut.points_vert,fragmentShader:ut.points_frag},dashed:{uniforms:Vn([Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ut.linedashed_vert,fragmentShader:ut.linedashed_frag},depth:{uniforms:Vn([Le.common,Le.displacementmap]),vertexShader:ut.depth_vert,fragmentShader:ut.depth_frag},normal:{uniforms:Vn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,{opacity:{value:1}}]),vertexShader:ut.meshnormal_vert,fragmentShader:ut.meshnormal_frag},sprite:{uniforms:Vn([Le.sprite,Le.fog]),vertexShader:ut.sprite_vert,fragmentShader:ut.sprite_frag},background:{uniforms:{uvTransform:{value:new et},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ut.background_vert,fragmentShader:ut.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new et}},vertexShader:ut.backgroundCube_vert,fragmentShader:ut.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ut.cube_vert,fragmentShader:ut.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ut.equirect_vert,fragmentShader:ut.equirect_frag},distance:{uniforms:Vn([Le.common,Le.displacementmap,{referencePosition:{value:new G},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ut.distance_vert,fragmentShader:ut.distance_frag},shadow:{uniforms:Vn([Le.lights,Le.fog,{color:{value:new $e(0)},opacity:{value:1}}]),vertexShader:ut.shadow_vert,fragmentShader:ut.shadow_frag}};ns.physical={uniforms:Vn([ns.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new et},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new et},clearcoatNormalScale:{value:new Ye(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new et},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new et},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new et},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new et},sheen:{value:0},sheenColor:{value:new $e(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new et},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new et},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new et},transmissionSamplerSize:{value:new Ye},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new et},attenuationDistance:{value:0},attenuationColor:{value:new $e(0)},specularColor:{value:new $e(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new et},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new et},anisotropyVector:{value:new Ye},anisotropyMap:{value:null},anisotropyMapTransform:{value:new et}}]),vertexShader:ut.meshphysical_vert,fragmentShader:ut.meshphysical_frag};var lu={r:0,b:0,g:0},dw=new at,zg=new et;zg.set(-1,0,0,0,1,0,0,0,1);function fw(n,e,t,i,s,r){let o=new $e(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(_){let b=_.isScene===!0?_.background:null;if(b&&b.isTexture){let v=_.backgroundBlurriness>0;b=e.get(b,v)}return b}function p(_){let b=!1,v=f(_);v===null?g(o,a):v&&v.isColor&&(g(v,1),b=!0);let E=n.xr.getEnvironmentBlendMode();E==="additive"?t.buffers.color.setClear(0,0,0,1,r):E==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||b)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(_,b){let v=f(b);v&&v.isCubeTexture?(c===void 0&&(c=new On(new xo(1,1,1),new Qi({name:"BackgroundCubeMaterial",uniforms:Tr(ns.backgroundCube.uniforms),vertexShader:ns.backgroundCube.vertexShader,fragmentShader:ns.backgroundCube.fragmentShader,side:Kn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(E,A,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=v,c.material.uniforms.backgroundBlurriness.value=b.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(dw.makeRotationFromEuler(b.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(zg),c.material.toneMapped=xt.getTransfer(v.colorSpace)!==Tt,(u!==v||h!==v.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),c.layers.enableAll(),_.unshift(c,c.geometry,c.material,0,0,null)):v&&v.isTexture&&(l===void 0&&(l=new On(new Ta(2,2),new Qi({name:"BackgroundMaterial",uniforms:Tr(ns.background.uniforms),vertexShader:ns.background.vertexShader,fragmentShader:ns.background.fragmentShader,side:Js,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=v,l.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,l.material.toneMapped=xt.getTransfer(v.colorSpace)!==Tt,v.matrixAutoUpdate===!0&&v.updateMatrix(),l.material.uniforms.uvTransform.value.copy(v.matrix),(u!==v||h!==v.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null))}function g(_,b){_.getRGB(lu,zd(n)),t.buffers.color.setClear(lu.r,lu.g,lu.b,b,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(_,b=1){o.set(_),a=b,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(_){a=_,g(o,a)},render:p,addToRenderList:x,dispose:m}}function pw(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(C,D,k,N,B){let $=!1,H=h(C,N,k,D);r!==H&&(r=H,c(r.object)),$=f(C,N,k,B),$&&p(C,N,k,B),B!==null&&e.update(B,n.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,v(C,D,k,N),B!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(B).buffer))}function l(){return n.createVertexArray()}function c(C){return n.bindVertexArray(C)}function u(C){return n.deleteVertexArray(C)}function h(C,D,k,N){let B=N.wireframe===!0,$=i[D.id];$===void 0&&($={},i[D.id]=$);let H=C.isInstancedMesh===!0?C.id:0,se=$[H];se===void 0&&(se={},$[H]=se);let Y=se[k.id];Y===void 0&&(Y={},se[k.id]=Y);let Q=Y[B];return Q===void 0&&(Q=d(l()),Y[B]=Q),Q}function d(C){let D=[],k=[],N=[];for(let B=0;B<t;B++)D[B]=0,k[B]=0,N[B]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:D,enabledAttributes:k,attributeDivisors:N,object:C,attributes:{},index:null}}function f(C,D,k,N){let B=r.attributes,$=D.attributes,H=0,se=k.getAttributes();for(let Y in se)if(se[Y].location>=0){let ie=B[Y],fe=$[Y];if(fe===void 0&&(Y==="instanceMatrix"&&C.instanceMatrix&&(fe=C.instanceMatrix),Y==="instanceColor"&&C.instanceColor&&(fe=C.instanceColor)),ie===void 0||ie.attribute!==fe||fe&&ie.data!==fe.data)return!0;H++}return r.attributesNum!==H||r.index!==N}function p(C,D,k,N){let B={},$=D.attributes,H=0,se=k.getAttributes();for(let Y in se)if(se[Y].location>=0){let ie=$[Y];ie===void 0&&(Y==="instanceMatrix"&&C.instanceMatrix&&(ie=C.instanceMatrix),Y==="instanceColor"&&C.instanceColor&&(ie=C.instanceColor));let fe={};fe.attribute=ie,ie&&ie.data&&(fe.data=ie.data),B[Y]=fe,H++}r.attributes=B,r.attributesNum=H,r.index=N}function x(){let C=r.newAttributes;for(let D=0,k=C.length;D<k;D++)C[D]=0}function g(C){m(C,0)}function m(C,D){let k=r.newAttributes,N=r.enabledAttributes,B=r.attributeDivisors;k[C]=1,N[C]===0&&(n.enableVertexAttribArray(C),N[C]=1),B[C]!==D&&(n.vertexAttribDivisor(C,D),B[C]=D)}function _(){let C=r.newAttributes,D=r.enabledAttributes;for(let k=0,N=D.length;k<N;k++)D[k]!==C[k]&&(n.disableVertexAttribArray(k),D[k]=0)}function b(C,D,k,N,B,$,H){H===!0?n.vertexAttribIPointer(C,D,k,B,$):n.vertexAttribPointer(C,D,k,N,B,$)}function v(C,D,k,N){x();let B=N.attributes,$=k.getAttributes(),H=D.defaultAttributeValues;for(let se in $){let Y=$[se];if(Y.location>=0){let Q=B[se];if(Q===void 0&&(se==="instanceMatrix"&&C.instanceMatrix&&(Q=C.instanceMatrix),se==="instanceColor"&&C.instanceColor&&(Q=C.instanceColor)),Q!==void 0){let ie=Q.normalized,fe=Q.itemSize,de=e.get(Q);if(de===void 0)continue;let ee=de.buffer,he=de.type,ge=de.bytesPerElement,Se=he===n.INT||he===n.UNSIGNED_INT||Q.gpuType===wc;if(Q.isInterleavedBufferAttribute){let Me=Q.data,He=Me.isInterleavedBuffer===!0?Me.stride:Me.itemSize,st=Q.offset;if(Me.isInstancedInterleavedBuffer||Me.isInstancedBufferAttribute){for(let Ve=0;Ve<Y.locationSize;Ve++)m(Y.location+Ve,Me.meshPerAttribute);C.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Me.meshPerAttribute*Me.count)}else for(let Ve=0;Ve<Y.locationSize;Ve++)g(Y.location+Ve);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Ve=0;Ve<Y.locationSize;Ve++)b(Y.location+Ve,fe/Y.locationSize,he,ie,He*ge,(st+fe/Y.locationSize*Ve)*ge,Se)}else{if(Q.isInstancedBufferAttribute){for(let Me=0;Me<Y.locationSize;Me++)m(Y.location+Me,Q.meshPerAttribute);C.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let Me=0;Me<Y.locationSize;Me++)g(Y.location+Me);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Me=0;Me<Y.locationSize;Me++)b(Y.location+Me,fe/Y.locationSize,he,ie,fe*ge,fe/Y.locationSize*Me*ge,Se)}}else if(H!==void 0){let ie=H[se];if(ie!==void 0)switch(ie.length){case 2:n.vertexAttrib2fv(Y.location,ie);break;case 3:n.vertexAttrib3fv(Y.location,ie);break;case 4:n.vertexAttrib4fv(Y.location,ie);break;default:n.vertexAttrib1fv(Y.location,ie)}}}}_()}function E(){I();for(let C in i){let D=i[C];for(let k in D){let N=D[k];for(let B in N){let $=N[B];for(let H in $)u($[H].object),delete $[H];delete N[B]}}delete i[C]}}function A(C){if(i[C.id]===void 0)return;let D=i[C.id];for(let k in D){let N=D[k];for(let B in N){let $=N[B];for(let H in $)u($[H].object),delete $[H];delete N[B]}}delete i[C.id]}function y(C){for(let D in i){let k=i[D];for(let N in k){let B=k[N];if(B[C.id]===void 0)continue;let $=B[C.id];for(let H in $)u($[H].object),delete $[H];delete B[C.id]}}}function M(C){for(let D in i){let k=i[D],N=C.isInstancedMesh===!0?C.id:0,B=k[N];if(B!==void 0){for(let $ in B){let H=B[$];for(let se in H)u(H[se].object),delete H[se];delete B[$]}delete k[N],Object.keys(k).length===0&&delete i[D]}}}function I(){L(),o=!0,r!==s&&(r=s,c(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:I,resetDefaultState:L,dispose:E,releaseStatesOfGeometry:A,releaseStatesOfObject:M,releaseStatesOfProgram:y,initAttributes:x,enableAttribute:g,disableUnusedAttributes:_}}function mw(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];t.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function gw(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let y=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Ni&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let M=y===Li&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(y!==ei&&y!==bi&&!M&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(qe("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&qe("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&qe("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),_=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),b=n.getParameter(n.MAX_VARYING_VECTORS),v=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),E=n.getParameter(n.MAX_SAMPLES),A=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:p,maxTextureSize:x,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:_,maxVaryings:b,maxFragmentUniforms:v,maxSamples:E,samples:A}}function xw(n){let e=this,t=null,i=0,s=!1,r=!1,o=new ci,a=new et,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||s;return s=d,i=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){t=u(h,d,0)},this.setState=function(h,d,f){let p=h.clippingPlanes,x=h.clipIntersection,g=h.clipShadows,m=n.get(h);if(!s||p===null||p.length===0||r&&!g)r?u(null):c();else{let _=r?0:i,b=_*4,v=m.clippingState||null;l.value=v,v=u(p,d,b,f);for(let E=0;E!==b;++E)v[E]=t[E];m.clippingState=v,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=_}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,d,f,p){let x=h!==null?h.length:0,g=null;if(x!==0){if(g=l.value,p!==!0||g===null){let m=f+x*4,_=d.matrixWorldInverse;a.getNormalMatrix(_),(g===null||g.length<m)&&(g=new Float32Array(m));for(let b=0,v=f;b!==x;++b,v+=4)o.copy(h[b]).applyMatrix4(_,a),o.normal.toArray(g,v),g[v+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=x,e.numIntersection=0,g}}var Xa=class extends hi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Ma(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new xo(5,5,5),r=new Qi({name:"CubemapFromEquirect",uniforms:Tr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Kn,blending:Mr});r.uniforms.tEquirect.value=t;let o=new On(s,r),a=t.minFilter;return t.minFilter===Ms&&(t.minFilter=Zn),new yo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},_g=256,_w=3,yw=20,Vg=256,Gg=16,vw=3,bw=new G,Sw=new $e,uu=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new yo(1,10,null),this._boxMesh=new On(new xo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=bw}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,x=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(e.background=l.getClearColor(Sw));let g=new yo(i,s,u);return g.position.copy(a),g.update(l,e),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,e.background=x,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=bg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=vg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(_g,kd(e))}_fromTexture(e,t){e.mapping===Ar||e.mapping===Mo?this._setSize(e.image.length===0?_g:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=yg(e,!1,!1),i=Math.log2(e)-_w;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=yg(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Ar||e.mapping===Mo?(this._cubemapMaterial===null&&(this._cubemapMaterial=bg()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=vg()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=Mw(),this._integrationMaterial=ww());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Gg);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-vw)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Vg*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=Aw());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function yg(n,e,t){return new Xa(n,{minFilter:Ms,generateMipmaps:e,type:Li,colorSpace:pa,depthBuffer:t})}function qa(n,e,t){return new Qi({name:n,uniforms:e,vertexShader:ut.cube_vert,fragmentShader:t,side:Kn,blending:Mr,depthTest:!1,depthWrite:!1})}function Mw(){return qa("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Vg}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function ww(){return qa("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Gg}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Aw(){return qa("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${yw}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function vg(){return qa("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function bg(){return qa("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Ew(n){let e=new WeakMap,t=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===bc||f===Sc)if(e.has(d)){let p=e.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let x=new Xa(p.height);return x.fromEquirectangularTexture(n,d),e.set(d,x),d.addEventListener("dispose",c),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===bc||f===Sc,x=f===Ar||f===Mo;if(p||x){let g=t.get(d),m=g!==void 0?g.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return i===null&&(i=new uu(n)),g=p?i.fromEquirectangular(d,g):i.fromCubemap(d,g),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),g.texture;if(g!==void 0)return g.texture;{let _=d.image;return p&&_&&_.height>0||x&&_&&l(_)?(i===null&&(i=new uu(n)),g=p?i.fromEquirectangular(d):i.fromCubemap(d),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),d.addEventListener("dispose",u),g.texture):null}}}return d}function a(d,f){return f===bc?d.mapping=Ar:f===Sc&&(d.mapping=Mo),d}function l(d){let f=0,p=6;for(let x=0;x<p;x++)d[x]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function h(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function Tw(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&ua("WebGLRenderer: "+i+" extension not supported."),s}}}function Cw(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let g in p.attributes)e.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let x=r.get(p);x&&(e.remove(x),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),t.memory.geometries++),x}function u(p){let x=p.attributes;for(let g in x)e.update(x[g],n.ARRAY_BUFFER)}function h(p){let x=p.index,g=p.attributes.position,m=0;if(g===void 0)return;let _=x!==null?x.array.length:g.array.length/3-1,b=g.count>=65535?va:ya,v=new b(Math.ceil(_/3)*6,1),E=v.array;if(x!==null){let y=x.array;m=x.version;for(let M=0,I=0;M<_;M+=3){let L=y[M+0],C=y[M+1],D=y[M+2];E[I++]=L,E[I++]=C,E[I++]=C,E[I++]=D,E[I++]=D,E[I++]=L}}else{m=g.version;for(let y=0,M=0;y<_;y+=3){let I=y+0,L=y+1,C=y+2;E[M++]=I,E[M++]=L,E[M++]=L,E[M++]=C,E[M++]=C,E[M++]=I}}v.version=m;let A=r.get(p);A&&e.remove(A),r.set(p,v)}function d(p){let x=r.get(p);if(x){let g=p.index;g!==null&&x.version<g.version&&h(p)}else h(p);return r.get(p)}function f(){for(let p in s){let x=s[p].deref();x!==void 0&&l(x)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function Rw(n,e,t){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){n.drawElements(i,d,r,h*o),t.update(d,i,1)}function c(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,h*o,f),t.update(d,i,f))}function u(h,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,h,0,f);let x=0;for(let g=0;g<f;g++)x+=d[g];t.update(x,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function Pw(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:Qe("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function Iw(n,e,t){let i=new WeakMap,s=new Ft;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let I=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",I)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],_=a.morphAttributes.color||[],b=0;f===!0&&(b=1),p===!0&&(b=2),x===!0&&(b=3);let v=a.attributes.position.count*b,E=1;v>e.maxTextureSize&&(E=Math.ceil(v/e.maxTextureSize),v=e.maxTextureSize);let A=new Float32Array(v*E*4*h),y=new xa(A,v,E,h);y.type=bi,y.needsUpdate=!0;let M=b*4;for(let L=0;L<h;L++){let C=g[L],D=m[L],k=_[L],N=v*E*4*L;for(let B=0;B<C.count;B++){let $=B*M;f===!0&&(s.fromBufferAttribute(C,B),A[N+$+0]=s.x,A[N+$+1]=s.y,A[N+$+2]=s.z,A[N+$+3]=0),p===!0&&(s.fromBufferAttribute(D,B),A[N+$+4]=s.x,A[N+$+5]=s.y,A[N+$+6]=s.z,A[N+$+7]=0),x===!0&&(s.fromBufferAttribute(k,B),A[N+$+8]=s.x,A[N+$+9]=s.y,A[N+$+10]=s.z,A[N+$+11]=k.itemSize===4?s.w:1)}}d={count:h,texture:y,size:new Ye(v,E)},i.set(a,d),a.addEventListener("dispose",I)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let f=0;for(let x=0;x<c.length;x++)f+=c[x];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function Lw(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=e.get(c,h);if(r.get(d)!==u&&(e.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var Nw={[md]:"LINEAR_TONE_MAPPING",[gd]:"REINHARD_TONE_MAPPING",[xd]:"CINEON_TONE_MAPPING",[_d]:"ACES_FILMIC_TONE_MAPPING",[vd]:"AGX_TONE_MAPPING",[bd]:"NEUTRAL_TONE_MAPPING",[yd]:"CUSTOM_TONE_MAPPING"};function Dw(n,e,t,i,s,r){let o=new hi(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new yn;u.setAttribute("position",new sn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new sn([0,2,0,0,2,0],2));let h=new rc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new On(u,h),f=new La(-1,1,1,-1,0,1),p=null,x=null,g=!1,m,_=null,b=[],v=!1;this.setSize=function(E,A){o.setSize(E,A),a!==null&&a.setSize(E,A),l!==null&&l.setSize(E,A);for(let y=0;y<b.length;y++){let M=b[y];M.setSize&&M.setSize(E,A)}},this.setEffects=function(E){b=E,v=b.length>0&&b[0].isRenderPass===!0;let A=o.width,y=o.height;b.length>0&&a===null&&(a=new hi(A,y,{type:Li,depthBuffer:!1,stencilBuffer:!1}),l=new hi(A,y,{type:Li,depthBuffer:!1,stencilBuffer:!1}));let M=s===!0&&b.some(I=>I.needsDepthTexture===!0);M!==(o.depthTexture!==null)&&(M===!0&&c===null&&(c=new bs(A,y),r===!0&&(c.format=ws,c.type=Er)),o.dispose(),o.depthTexture=M?c:null,o.resolveDepthBuffer=M,o.storeMultisampledDepthBuffer=M);for(let I=0;I<b.length;I++){let L=b[I];L.setSize&&L.setSize(A,y),M&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(c)}},this.begin=function(E,A){if(g||E.toneMapping===es&&b.length===0)return!1;if(_=A,A!==null){let y=A.width,M=A.height;(o.width!==y||o.height!==M)&&this.setSize(y,M)}return v===!1&&E.setRenderTarget(o),m=E.toneMapping,E.toneMapping=es,!0},this.hasRenderPass=function(){return v},this.end=function(E,A){E.toneMapping=m,g=!0;let y=o,M=a;for(let I=0;I<b.length;I++){let L=b[I];L.enabled!==!1&&(L.render(E,M,y,A),L.needsSwap!==!1&&(y=M,M=M===a?l:a))}if(p!==E.outputColorSpace||x!==E.toneMapping){p=E.outputColorSpace,x=E.toneMapping,h.defines={},xt.getTransfer(p)===Tt&&(h.defines.SRGB_TRANSFER="");let I=Nw[x];I&&(h.defines[I]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=y.texture,E.setRenderTarget(_),E.render(d,f),_=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Hg=new Qn,Wg=new bs(1,1),$g=new wa(1),Xg=new xa,qg=new ec,Yg=new Ma,Sg=[],Mg=[],wg=new Float32Array(16),Ag=new Float32Array(9),Eg=new Float32Array(4);function To(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=Sg[s];if(r===void 0&&(r=new Float32Array(s),Sg[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function vn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function bn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function du(n,e){let t=Mg[e];t===void 0&&(t=new Int32Array(e),Mg[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function Ow(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function Uw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(vn(t,e))return;n.uniform2fv(this.addr,e),bn(t,e)}}function kw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(vn(t,e))return;n.uniform3fv(this.addr,e),bn(t,e)}}function Fw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(vn(t,e))return;n.uniform4fv(this.addr,e),bn(t,e)}}function Bw(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(vn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),bn(t,e)}else{if(vn(t,i))return;Eg.set(i),n.uniformMatrix2fv(this.addr,!1,Eg),bn(t,i)}}function zw(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(vn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),bn(t,e)}else{if(vn(t,i))return;Ag.set(i),n.uniformMatrix3fv(this.addr,!1,Ag),bn(t,i)}}function Vw(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(vn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),bn(t,e)}else{if(vn(t,i))return;wg.set(i),n.uniformMatrix4fv(this.addr,!1,wg),bn(t,i)}}function Gw(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function Hw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(vn(t,e))return;n.uniform2iv(this.addr,e),bn(t,e)}}function Ww(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(vn(t,e))return;n.uniform3iv(this.addr,e),bn(t,e)}}function $w(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(vn(t,e))return;n.uniform4iv(this.addr,e),bn(t,e)}}function Xw(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function qw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(vn(t,e))return;n.uniform2uiv(this.addr,e),bn(t,e)}}function Yw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(vn(t,e))return;n.uniform3uiv(this.addr,e),bn(t,e)}}function Zw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(vn(t,e))return;n.uniform4uiv(this.addr,e),bn(t,e)}}function fu(n){return n.version===0&&(n.compareFunction=Nd,n.needsUpdate=!0),n}function Kw(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=fu(Wg):r=Hg,t.setTexture2D(e||r,s)}function Jw(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||qg,s)}function jw(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=fu($g):r=Yg,t.setTextureCube(e||r,s)}function Qw(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||Xg,s)}function e1(n){switch(n){case 5126:return Ow;case 35664:return Uw;case 35665:return kw;case 35666:return Fw;case 35674:return Bw;case 35675:return zw;case 35676:return Vw;case 5124:case 35670:return Gw;case 35667:case 35671:return Hw;case 35668:case 35672:return Ww;case 35669:case 35673:return $w;case 5125:return Xw;case 36294:return qw;case 36295:return Yw;case 36296:return Zw;case 35678:case 36198:case 36298:case 36306:case 35682:return Kw;case 35679:case 36299:case 36307:return Jw;case 35680:case 36300:case 36308:case 36293:return jw;case 36289:case 36303:case 36311:case 36292:return Qw}}function t1(n,e){n.uniform1fv(this.addr,e)}function n1(n,e){let t=To(e,this.size,2);n.uniform2fv(this.addr,t)}function i1(n,e){let t=To(e,this.size,3);n.uniform3fv(this.addr,t)}function s1(n,e){let t=To(e,this.size,4);n.uniform4fv(this.addr,t)}function r1(n,e){let t=To(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function o1(n,e){let t=To(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function a1(n,e){let t=To(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function l1(n,e){n.uniform1iv(this.addr,e)}function c1(n,e){n.uniform2iv(this.addr,e)}function u1(n,e){n.uniform3iv(this.addr,e)}function h1(n,e){n.uniform4iv(this.addr,e)}function d1(n,e){n.uniform1uiv(this.addr,e)}function f1(n,e){n.uniform2uiv(this.addr,e)}function p1(n,e){n.uniform3uiv(this.addr,e)}function m1(n,e){n.uniform4uiv(this.addr,e)}function g1(n,e,t){let i=this.cache,s=e.length,r=du(t,s);vn(i,r)||(n.uniform1iv(this.addr,r),bn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=fu(Wg):o=Hg;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function x1(n,e,t){let i=this.cache,s=e.length,r=du(t,s);vn(i,r)||(n.uniform1iv(this.addr,r),bn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||qg,r[o])}function _1(n,e,t){let i=this.cache,s=e.length,r=du(t,s);vn(i,r)||(n.uniform1iv(this.addr,r),bn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=fu($g):o=Yg;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function y1(n,e,t){let i=this.cache,s=e.length,r=du(t,s);vn(i,r)||(n.uniform1iv(this.addr,r),bn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Xg,r[o])}function v1(n){switch(n){case 5126:return t1;case 35664:return n1;case 35665:return i1;case 35666:return s1;case 35674:return r1;case 35675:return o1;case 35676:return a1;case 5124:case 35670:return l1;case 35667:case 35671:return c1;case 35668:case 35672:return u1;case 35669:case 35673:return h1;case 5125:return d1;case 36294:return f1;case 36295:return p1;case 36296:return m1;case 35678:case 36198:case 36298:case 36306:case 35682:return g1;case 35679:case 36299:case 36307:return x1;case 35680:case 36300:case 36308:case 36293:return _1;case 36289:case 36303:case 36311:case 36292:return y1}}var Xd=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=e1(t.type)}},qd=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=v1(t.type)}},Yd=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},Wd=/(\w+)(\])?(\[|\.)?/g;function Tg(n,e){n.seq.push(e),n.map[e.id]=e}function b1(n,e,t){let i=n.name,s=i.length;for(Wd.lastIndex=0;;){let r=Wd.exec(i),o=Wd.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Tg(t,c===void 0?new Xd(a,n,e):new qd(a,n,e));break}else{let h=t.map[a];h===void 0&&(h=new Yd(a),Tg(t,h)),t=h}}}var Eo=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);b1(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function Cg(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var S1=37297,M1=0;function w1(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var Rg=new et;function A1(n){xt._getMatrix(Rg,xt.workingColorSpace,n);let e=`mat3( ${Rg.elements.map(t=>t.toFixed(4))} )`;switch(xt.getTransfer(n)){case ma:return[e,"LinearTransferOETF"];case Tt:return[e,"sRGBTransferOETF"];default:return qe("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function Pg(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+w1(n.getShaderSource(e),a)}else return r}function E1(n,e){let t=A1(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var T1={[md]:"Linear",[gd]:"Reinhard",[xd]:"Cineon",[_d]:"ACESFilmic",[vd]:"AgX",[bd]:"Neutral",[yd]:"Custom"};function C1(n,e){let t=T1[e];return t===void 0?(qe("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var cu=new G;function R1(){xt.getLuminanceCoefficients(cu);let n=cu.x.toFixed(4),e=cu.y.toFixed(4),t=cu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function P1(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter($a).join(`
`)}function I1(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function L1(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function $a(n){return n!==""}function Ig(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Lg(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var N1=/^[ \t]*#include +<([\w\d./]+)>/gm;function Zd(n){return n.replace(N1,D1)}function D1(n,e){let t=ut[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Zd(t)}var O1=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Ng(n){return n.replace(O1,U1)}function U1(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Dg(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var k1={[Oa]:"SHADOWMAP_TYPE_PCF",[bo]:"SHADOWMAP_TYPE_VSM"};function F1(n){return k1[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var B1={[Mo]:"ENVMAP_MODE_REFRACTION"};function z1(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":B1[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var V1={[vc]:"ENVMAP_BLENDING_MULTIPLY",[Km]:"ENVMAP_BLENDING_MIX",[Jm]:"ENVMAP_BLENDING_ADD"};function G1(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":V1[n.combine]||"ENVMAP_BLENDING_NONE"}function H1(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=F1(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=z1(t),h=G1(t),d=P1(t),f=I1(r),p=s.createProgram(),x,g,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(x=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter($a).join(`
`),x.length>0&&(x+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter($a).join(`
`),g.length>0&&(g+=`
`)):(x=[Dg(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter($a).join(`
`),g=[Dg(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==es?"#define TONE_MAPPING":"",t.toneMapping!==es?ut.tonemapping_pars_fragment:"",t.toneMapping!==es?C1("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ut.colorspace_pars_fragment,E1("linearToOutputTexel",t.outputColorSpace),R1(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter($a).join(`
`)),o=Zd(o),o=Ig(o,t),o=Lg(o,t),a=Zd(a),a=Ig(a,t),a=Lg(a,t),o=Ng(o),a=Ng(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,g=["#define varying in",t.glslVersion===Dd?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Dd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let _=m+x+o,b=m+g+a,v=Cg(s,s.VERTEX_SHADER,_),E=Cg(s,s.FRAGMENT_SHADER,b);s.attachShader(p,v),s.attachShader(p,E),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function A(L){if(n.debug.checkShaderErrors){let C=s.getProgramInfoLog(p)||"",D=s.getShaderInfoLog(v)||"",k=s.getShaderInfoLog(E)||"",N=C.trim(),B=D.trim(),$=k.trim(),H=!0,se=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(H=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,v,E);else{let Y=Pg(s,v,"vertex"),Q=Pg(s,E,"fragment");Qe("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+N+`
`+Y+`
`+Q)}else N!==""?qe("WebGLProgram: Program Info Log:",N):(B===""||$==="")&&(se=!1);se&&(L.diagnostics={runnable:H,programLog:N,vertexShader:{log:B,prefix:x},fragmentShader:{log:$,prefix:g}})}s.deleteShader(v),s.deleteShader(E),y=new Eo(s,p),M=L1(s,p)}let y;this.getUniforms=function(){return y===void 0&&A(this),y};let M;this.getAttributes=function(){return M===void 0&&A(this),M};let I=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return I===!1&&(I=s.getProgramParameter(p,S1)),I},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=M1++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=v,this.fragmentShader=E,this}var W1=0,Kd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Jd(e),t.set(e,i)),i}},Jd=class{constructor(e){this.id=W1++,this.code=e,this.usedTimes=0}};function $1(n){return n===js||n===Va||n===Ga}function X1(n,e,t,i,s,r){let o=new mo,a=new Kd,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function p(y,M,I,L,C,D){let k=L.fog,N=C.geometry,B=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?L.environment:null,$=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,H=e.get(y.envMap||B,$),se=d[y.type],Y=i.precision;y.precision!==null&&(Y=i.getMaxPrecision(y.precision),Y!==y.precision&&qe("WebGLProgram.getParameters:",y.precision,"not supported, using",Y,"instead."));let Q=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,ie=Q!==void 0?Q.length:0,fe=0;N.morphAttributes.position!==void 0&&(fe=1),N.morphAttributes.normal!==void 0&&(fe=2),N.morphAttributes.color!==void 0&&(fe=3);let de,ee,he,ge;if(se){let Ce=ns[se];de=Ce.vertexShader,ee=Ce.fragmentShader}else{de=y.vertexShader,ee=y.fragmentShader;let Ce=a.getVertexShaderStage(y),ot=a.getFragmentShaderStage(y);a.update(y,Ce,ot),he=Ce.id,ge=ot.id}let Se=n.getRenderTarget(),Me=n.state.buffers.depth.getReversed(),He=C.isInstancedMesh===!0,st=C.isBatchedMesh===!0,Ve=!!y.map,ht=!!y.matcap,lt=!!H,nt=lt&&H.isPMREMTexture===!0,Zt=!!y.aoMap,Vt=!!y.lightMap,cn=!!y.bumpMap&&y.wireframe===!1,Nt=!!y.normalMap,An=!!y.displacementMap,vt=!!y.emissiveMap,xn=!!y.metalnessMap,jt=!!y.roughnessMap,un=y.anisotropy>0,V=y.clearcoat>0,Re=y.diffuseRoughness>0,Ze=y.dispersion>0,rt=y.retroreflectivity>0,we=y.iridescence>0,kt=y.sheen>0,ze=y.transmission>0,Xe=un&&!!y.anisotropyMap,O=V&&!!y.clearcoatMap,T=V&&!!y.clearcoatNormalMap,q=V&&!!y.clearcoatRoughnessMap,ue=Re&&!!y.diffuseRoughnessMap,ae=we&&!!y.iridescenceMap,_e=we&&!!y.iridescenceThicknessMap,ye=kt&&!!y.sheenColorMap,te=kt&&!!y.sheenRoughnessMap,re=!!y.specularMap,me=!!y.specularColorMap,z=!!y.specularIntensityMap,oe=ze&&!!y.transmissionMap,ne=ze&&!!y.thicknessMap,Ae=!!y.gradientMap,xe=!!y.alphaMap,be=y.alphaTest>0,Ge=!!y.alphaHash,Je=!!y.extensions,ce=es;y.toneMapped&&(Se===null||Se.isXRRenderTarget===!0)&&(ce=n.toneMapping);let ke=nt?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,je={shaderID:se,shaderType:y.type,shaderName:y.name,vertexShader:de,fragmentShader:ee,defines:y.defines,customVertexShaderID:he,customFragmentShaderID:ge,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:Y,batching:st,batchingColor:st&&C._colorsTexture!==null,instancing:He,instancingColor:He&&C.instanceColor!==null,instancingMorph:He&&C.morphTexture!==null,outputColorSpace:Se===null?n.outputColorSpace:Se.isXRRenderTarget===!0?Se.texture.colorSpace:xt.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Ve,matcap:ht,envMap:lt,envMapMode:lt&&H.mapping,envMapPMREM:nt,envMapMaxLod:nt?ke.length-1:null,envMapSize:nt?ke[0].width:null,aoMap:Zt,lightMap:Vt,bumpMap:cn,normalMap:Nt,displacementMap:An,emissiveMap:vt,normalMapObjectSpace:Nt&&y.normalMapType===eg,normalMapTangentSpace:Nt&&y.normalMapType===au,packedNormalMap:Nt&&y.normalMapType===au&&$1(y.normalMap.format),metalnessMap:xn,roughnessMap:jt,anisotropy:un,anisotropyMap:Xe,clearcoat:V,clearcoatMap:O,clearcoatNormalMap:T,clearcoatRoughnessMap:q,diffuseRoughness:Re,diffuseRoughnessMap:ue,dispersion:Ze,retroreflection:rt,iridescence:we,iridescenceMap:ae,iridescenceThicknessMap:_e,sheen:kt,sheenColorMap:ye,sheenRoughnessMap:te,specularMap:re,specularColorMap:me,specularIntensityMap:z,transmission:ze,transmissionMap:oe,thicknessMap:ne,gradientMap:Ae,opaque:y.transparent===!1&&y.blending===So&&y.alphaToCoverage===!1,alphaMap:xe,alphaTest:be,alphaHash:Ge,combine:y.combine,mapUv:Ve&&f(y.map.channel),aoMapUv:Zt&&f(y.aoMap.channel),lightMapUv:Vt&&f(y.lightMap.channel),bumpMapUv:cn&&f(y.bumpMap.channel),normalMapUv:Nt&&f(y.normalMap.channel),displacementMapUv:An&&f(y.displacementMap.channel),emissiveMapUv:vt&&f(y.emissiveMap.channel),metalnessMapUv:xn&&f(y.metalnessMap.channel),roughnessMapUv:jt&&f(y.roughnessMap.channel),anisotropyMapUv:Xe&&f(y.anisotropyMap.channel),clearcoatMapUv:O&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:T&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:ae&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:_e&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:ye&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:te&&f(y.sheenRoughnessMap.channel),specularMapUv:re&&f(y.specularMap.channel),specularColorMapUv:me&&f(y.specularColorMap.channel),specularIntensityMapUv:z&&f(y.specularIntensityMap.channel),transmissionMapUv:oe&&f(y.transmissionMap.channel),thicknessMapUv:ne&&f(y.thicknessMap.channel),alphaMapUv:xe&&f(y.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Nt||un),vertexNormals:!!N.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:C.isPoints===!0&&!!N.attributes.uv&&(Ve||xe),fog:!!k,useFog:y.fog===!0,fogExp2:!!k&&k.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||N.attributes.normal===void 0&&Nt===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Me,skinning:C.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:fe,numSunLights:M.sun.length,numDirLights:M.directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.hemi.length,numSunLightShadows:M.sunShadowMap.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numLightProbeGrids:D.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&I.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:Ve&&y.map.isVideoTexture===!0&&xt.getTransfer(y.map.colorSpace)===Tt,decodeVideoTextureEmissive:vt&&y.emissiveMap.isVideoTexture===!0&&xt.getTransfer(y.emissiveMap.colorSpace)===Tt,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===zn,flipSided:y.side===Kn,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:Je&&y.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Je&&y.extensions.multiDraw===!0||st)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return je.vertexUv1s=l.has(1),je.vertexUv2s=l.has(2),je.vertexUv3s=l.has(3),l.clear(),je}function x(y){let M=[];if(y.shaderID?M.push(y.shaderID):(M.push(y.customVertexShaderID),M.push(y.customFragmentShaderID)),y.defines!==void 0)for(let I in y.defines)M.push(I),M.push(y.defines[I]);return y.isRawShaderMaterial===!1&&(g(M,y),m(M,y),M.push(n.outputColorSpace)),M.push(y.customProgramCacheKey),M.join()}function g(y,M){y.push(M.precision),y.push(M.outputColorSpace),y.push(M.envMapMode),y.push(M.envMapPMREM),y.push(M.envMapMaxLod),y.push(M.envMapSize),y.push(M.mapUv),y.push(M.alphaMapUv),y.push(M.lightMapUv),y.push(M.aoMapUv),y.push(M.bumpMapUv),y.push(M.normalMapUv),y.push(M.displacementMapUv),y.push(M.emissiveMapUv),y.push(M.metalnessMapUv),y.push(M.roughnessMapUv),y.push(M.anisotropyMapUv),y.push(M.clearcoatMapUv),y.push(M.clearcoatNormalMapUv),y.push(M.clearcoatRoughnessMapUv),y.push(M.diffuseRoughnessMapUv),y.push(M.iridescenceMapUv),y.push(M.iridescenceThicknessMapUv),y.push(M.sheenColorMapUv),y.push(M.sheenRoughnessMapUv),y.push(M.specularMapUv),y.push(M.specularColorMapUv),y.push(M.specularIntensityMapUv),y.push(M.transmissionMapUv),y.push(M.thicknessMapUv),y.push(M.combine),y.push(M.fogExp2),y.push(M.sizeAttenuation),y.push(M.morphTargetsCount),y.push(M.numSunLights),y.push(M.numDirLights),y.push(M.numPointLights),y.push(M.numSpotLights),y.push(M.numSpotLightMaps),y.push(M.numHemiLights),y.push(M.numRectAreaLights),y.push(M.numSunLightShadows),y.push(M.numDirLightShadows),y.push(M.numPointLightShadows),y.push(M.numSpotLightShadows),y.push(M.numSpotLightShadowsWithMaps),y.push(M.numLightProbes),y.push(M.numLightProbeGrids),y.push(M.shadowMapType),y.push(M.toneMapping),y.push(M.numClippingPlanes),y.push(M.numClipIntersection),y.push(M.depthPacking)}function m(y,M){o.disableAll(),M.instancing&&o.enable(0),M.instancingColor&&o.enable(1),M.instancingMorph&&o.enable(2),M.matcap&&o.enable(3),M.envMap&&o.enable(4),M.normalMapObjectSpace&&o.enable(5),M.normalMapTangentSpace&&o.enable(6),M.clearcoat&&o.enable(7),M.iridescence&&o.enable(8),M.alphaTest&&o.enable(9),M.vertexColors&&o.enable(10),M.vertexAlphas&&o.enable(11),M.vertexUv1s&&o.enable(12),M.vertexUv2s&&o.enable(13),M.vertexUv3s&&o.enable(14),M.vertexTangents&&o.enable(15),M.anisotropy&&o.enable(16),M.alphaHash&&o.enable(17),M.batching&&o.enable(18),M.dispersion&&o.enable(19),M.retroreflection&&o.enable(24),M.diffuseRoughness&&o.enable(25),M.batchingColor&&o.enable(20),M.gradientMap&&o.enable(21),M.packedNormalMap&&o.enable(22),M.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),M.fog&&o.enable(0),M.useFog&&o.enable(1),M.flatShading&&o.enable(2),M.logarithmicDepthBuffer&&o.enable(3),M.reversedDepthBuffer&&o.enable(4),M.skinning&&o.enable(5),M.morphTargets&&o.enable(6),M.morphNormals&&o.enable(7),M.morphColors&&o.enable(8),M.premultipliedAlpha&&o.enable(9),M.shadowMapEnabled&&o.enable(10),M.doubleSided&&o.enable(11),M.flipSided&&o.enable(12),M.useDepthPacking&&o.enable(13),M.dithering&&o.enable(14),M.transmission&&o.enable(15),M.sheen&&o.enable(16),M.opaque&&o.enable(17),M.pointsUvs&&o.enable(18),M.decodeVideoTexture&&o.enable(19),M.decodeVideoTextureEmissive&&o.enable(20),M.alphaToCoverage&&o.enable(21),M.numLightProbeGrids>0&&o.enable(22),M.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function _(y){let M=d[y.type],I;if(M){let L=ns[M];I=mg.clone(L.uniforms)}else I=y.uniforms;return I}function b(y,M){let I=u.get(M);return I!==void 0?++I.usedTimes:(I=new H1(n,M,y,s),c.push(I),u.set(M,I)),I}function v(y){if(--y.usedTimes===0){let M=c.indexOf(y);c[M]=c[c.length-1],c.pop(),u.delete(y.cacheKey),y.destroy()}}function E(y){a.remove(y)}function A(){a.dispose()}return{getParameters:p,getProgramCacheKey:x,getUniforms:_,acquireProgram:b,releaseProgram:v,releaseShaderCache:E,programs:c,dispose:A}}function q1(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function Y1(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Og(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Ug(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,x,g,m){let _=n[e];return _===void 0?(_={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:g,group:m},n[e]=_):(_.id=d.id,_.object=d,_.geometry=f,_.material=p,_.materialVariant=o(d),_.groupOrder=x,_.renderOrder=d.renderOrder,_.z=g,_.group=m),e++,_}function l(d,f,p,x,g,m,_){_.reversedDepth===!0&&(g=-g);let b=a(d,f,p,x,g,m);p.transmission>0?i.push(b):p.transparent===!0?s.push(b):t.push(b)}function c(d,f,p,x,g,m){let _=a(d,f,p,x,g,m);p.transmission>0?i.unshift(_):p.transparent===!0?s.unshift(_):t.unshift(_)}function u(d,f){t.length>1&&t.sort(d||Y1),i.length>1&&i.sort(f||Og),s.length>1&&s.sort(f||Og)}function h(){for(let d=e,f=n.length;d<f;d++){let p=n[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function Z1(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new Ug,n.set(i,[o])):s>=r.length?(o=new Ug,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function K1(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new G,color:new $e};break;case"SpotLight":t={position:new G,direction:new G,color:new $e,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new G,color:new $e,distance:0,decay:0};break;case"HemisphereLight":t={direction:new G,skyColor:new $e,groundColor:new $e};break;case"RectAreaLight":t={color:new $e,position:new G,halfWidth:new G,halfHeight:new G};break}return n[e.id]=t,t}}}function J1(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ye};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ye};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ye,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var j1=0;function Q1(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function eA(n){let e=new K1,t=J1(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new G);let s=new G,r=new at,o=new at;function a(c){let u=0,h=0,d=0;for(let D=0;D<9;D++)i.probe[D].set(0,0,0);let f=0,p=0,x=0,g=0,m=0,_=0,b=0,v=0,E=0,A=0,y=0,M=0,I=0,L=0;c.sort(Q1);for(let D=0,k=c.length;D<k;D++){let N=c[D],B=N.color,$=N.intensity,H=N.distance,se=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===js?se=N.shadow.map.texture:se=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)u+=B.r*$,h+=B.g*$,d+=B.b*$;else if(N.isLightProbe){for(let Y=0;Y<9;Y++)i.probe[Y].addScaledVector(N.sh.coefficients[Y],$);L++}else if(N.isSunLight){let Y=e.get(N);if(Y.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[p]=ie,i.sunShadowMap[p]=se;let fe=Q.getViewportCount();for(let de=0;de<fe;de++)i.sunShadowMatrix[x+de]=Q.getMatrix(de),i.sunShadowCascade[x+de]=Q._cascadeData[de];x+=fe,p++}i.sun[f]=Y,f++}else if(N.isDirectionalLight){let Y=e.get(N);if(Y.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,i.directionalShadow[g]=ie,i.directionalShadowMap[g]=se,i.directionalShadowMatrix[g]=N.shadow.matrix,E++}i.directional[g]=Y,g++}else if(N.isSpotLight){let Y=e.get(N);Y.position.setFromMatrixPosition(N.matrixWorld),Y.color.copy(B).multiplyScalar($),Y.distance=H,Y.coneCos=Math.cos(N.angle),Y.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),Y.decay=N.decay,i.spot[_]=Y;let Q=N.shadow;if(N.map&&(i.spotLightMap[M]=N.map,M++,Q.updateMatrices(N),N.castShadow&&I++),i.spotLightMatrix[_]=Q.matrix,N.castShadow){let ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,i.spotShadow[_]=ie,i.spotShadowMap[_]=se,y++}_++}else if(N.isRectAreaLight){let Y=e.get(N);Y.color.copy(B).multiplyScalar($),Y.halfWidth.set(N.width*.5,0,0),Y.halfHeight.set(0,N.height*.5,0),i.rectArea[b]=Y,b++}else if(N.isPointLight){let Y=e.get(N);if(Y.color.copy(N.color).multiplyScalar(N.intensity),Y.distance=N.distance,Y.decay=N.decay,N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,ie.shadowCameraNear=Q.camera.near,ie.shadowCameraFar=Q.camera.far,i.pointShadow[m]=ie,i.pointShadowMap[m]=se,i.pointShadowMatrix[m]=N.shadow.matrix,A++}i.point[m]=Y,m++}else if(N.isHemisphereLight){let Y=e.get(N);Y.skyColor.copy(N.color).multiplyScalar($),Y.groundColor.copy(N.groundColor).multiplyScalar($),i.hemi[v]=Y,v++}}b>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Le.LTC_FLOAT_1,i.rectAreaLTC2=Le.LTC_FLOAT_2):(i.rectAreaLTC1=Le.LTC_HALF_1,i.rectAreaLTC2=Le.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let C=i.hash;(C.sunLength!==f||C.directionalLength!==g||C.pointLength!==m||C.spotLength!==_||C.rectAreaLength!==b||C.hemiLength!==v||C.numSunShadows!==p||C.numDirectionalShadows!==E||C.numPointShadows!==A||C.numSpotShadows!==y||C.numSpotMaps!==M||C.numLightProbes!==L)&&(i.sun.length=f,i.directional.length=g,i.spot.length=_,i.rectArea.length=b,i.point.length=m,i.hemi.length=v,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=E,i.directionalShadowMap.length=E,i.directionalShadowMatrix.length=E,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+M-I,i.spotLightMap.length=M,i.numSpotLightShadowsWithMaps=I,i.numLightProbes=L,C.sunLength=f,C.directionalLength=g,C.pointLength=m,C.spotLength=_,C.rectAreaLength=b,C.hemiLength=v,C.numSunShadows=p,C.numDirectionalShadows=E,C.numPointShadows=A,C.numSpotShadows=y,C.numSpotMaps=M,C.numLightProbes=L,i.version=j1++)}function l(c,u){let h=0,d=0,f=0,p=0,x=0,g=0,m=u.matrixWorldInverse;for(let _=0,b=c.length;_<b;_++){let v=c[_];if(v.isSunLight){let E=i.sun[h];E.direction.setFromMatrixPosition(v.matrixWorld),E.direction.transformDirection(m),h++}else if(v.isDirectionalLight){let E=i.directional[d];E.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(m),d++}else if(v.isSpotLight){let E=i.spot[p];E.position.setFromMatrixPosition(v.matrixWorld),E.position.applyMatrix4(m),E.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(m),p++}else if(v.isRectAreaLight){let E=i.rectArea[x];E.position.setFromMatrixPosition(v.matrixWorld),E.position.applyMatrix4(m),o.identity(),r.copy(v.matrixWorld),r.premultiply(m),o.extractRotation(r),E.halfWidth.set(v.width*.5,0,0),E.halfHeight.set(0,v.height*.5,0),E.halfWidth.applyMatrix4(o),E.halfHeight.applyMatrix4(o),x++}else if(v.isPointLight){let E=i.point[f];E.position.setFromMatrixPosition(v.matrixWorld),E.position.applyMatrix4(m),f++}else if(v.isHemisphereLight){let E=i.hemi[g];E.direction.setFromMatrixPosition(v.matrixWorld),E.direction.transformDirection(m),g++}}}return{setup:a,setupView:l,state:i}}function kg(n){let e=new eA(n),t=[],i=[],s=[];function r(h){u.camera=h,t.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):t.push(h)}function a(h){i.push(h)}function l(){e.setup(t),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function tA(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new kg(n),e.set(s,[a])):r>=o.length?(a=new kg(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var nA=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,iA=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,sA=[new G(1,0,0),new G(-1,0,0),new G(0,1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1)],rA=[new G(0,-1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1),new G(0,-1,0),new G(0,-1,0)],Fg=new at,Wa=new G,$d=new G;function oA(n,e,t){let i=new Ws,s=new Ye,r=new Ye,o=new Ft,a=new oc,l=new ac,c={},u=t.maxTextureSize,h={[Js]:Kn,[Kn]:Js,[zn]:zn},d=new Qi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ye},radius:{value:4}},vertexShader:nA,fragmentShader:iA}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new yn;p.setAttribute("position",new an(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new On(p,d),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Oa;let m=this.type;this.render=function(A,y,M){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||A.length===0)return;this.type===Im&&(qe("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Oa);let I=n.getRenderTarget(),L=n.getActiveCubeFace(),C=n.getActiveMipmapLevel(),D=n.state;D.setBlending(Mr),D.buffers.depth.getReversed()===!0?D.buffers.color.setClear(0,0,0,0):D.buffers.color.setClear(1,1,1,1),D.buffers.depth.setTest(!0),D.setScissorTest(!1);let k=m!==this.type;k&&y.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(B=>B.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,B=A.length;N<B;N++){let $=A[N],H=$.shadow;if(H===void 0){qe("WebGLShadowMap:",$,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let se=H.getFrameExtents();s.multiply(se),r.copy(H.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/se.x),s.x=r.x*se.x,H.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/se.y),s.y=r.y*se.y,H.mapSize.y=r.y));let Y=n.state.buffers.depth.getReversed();if(H.camera._reversedDepth=Y,H.map===null||k===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===bo){if($.isPointLight){qe("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new hi(s.x,s.y,{format:js,type:Li,minFilter:Zn,magFilter:Zn,generateMipmaps:!1}),H.map.texture.name=$.name+".shadowMap",H.map.depthTexture=new bs(s.x,s.y,bi),H.map.depthTexture.name=$.name+".shadowMapDepth",H.map.depthTexture.format=xs,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=In,H.map.depthTexture.magFilter=In}else $.isPointLight?(H.map=new Xa(s.x),H.map.depthTexture=new wa(s.x,Ii)):(H.map=new hi(s.x,s.y),H.map.depthTexture=new bs(s.x,s.y,Ii)),H.map.depthTexture.name=$.name+".shadowMap",H.map.depthTexture.format=xs,this.type===Oa?(H.map.depthTexture.compareFunction=Y?Ld:Id,H.map.depthTexture.minFilter=Zn,H.map.depthTexture.magFilter=Zn):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=In,H.map.depthTexture.magFilter=In);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let Q=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();$.isPointLight!==!0&&H.updateMatrices($,M);let ie=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:M.layers;for(let fe=0;fe<Q;fe++){let de=H.getCamera(fe);if($.isPointLight){let ee=H.camera,he=H.matrix,ge=$.distance||ee.far;ge!==ee.far&&(ee.far=ge,ee.updateProjectionMatrix()),Wa.setFromMatrixPosition($.matrixWorld),ee.position.copy(Wa),$d.copy(ee.position),$d.add(sA[fe]),ee.up.copy(rA[fe]),ee.lookAt($d),ee.updateMatrixWorld(),he.makeTranslation(-Wa.x,-Wa.y,-Wa.z),Fg.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),H._frustum.setFromProjectionMatrix(Fg,ee.coordinateSystem,ee.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)n.setRenderTarget(H.map,fe),n.clear();else{fe===0&&(n.setRenderTarget(H.map),n.clear());let ee=H.getViewport(fe);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),D.viewport(o)}i=H.getFrustum(fe),v(y,M,de,$,ie,this.type)}H.isPointLightShadow!==!0&&this.type===bo&&_(H,M),H.needsUpdate=!1}m=this.type,g.needsUpdate=!1,n.setRenderTarget(I,L,C)};function _(A,y){let M=e.update(x);d.defines.VSM_SAMPLES!==A.blurSamples&&(d.defines.VSM_SAMPLES=A.blurSamples,f.defines.VSM_SAMPLES=A.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),A.mapPass===null?A.mapPass=new hi(s.x,s.y,{format:js,type:Li}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),d.uniforms.shadow_pass.value=A.map.depthTexture,d.uniforms.resolution.value.set(A.map.width,A.map.height),d.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(y,null,M,d,x,null),f.uniforms.shadow_pass.value=A.mapPass.texture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(y,null,M,f,x,null)}function b(A,y,M,I){let L=null,C=M.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(C!==void 0)L=C;else if(L=M.isPointLight===!0?l:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let D=L.uuid,k=y.uuid,N=c[D];N===void 0&&(N={},c[D]=N);let B=N[k];B===void 0&&(B=L.clone(),N[k]=B,y.addEventListener("dispose",E)),L=B}if(L.visible=y.visible,L.wireframe=y.wireframe,I===bo?L.side=y.shadowSide!==null?y.shadowSide:y.side:L.side=y.shadowSide!==null?y.shadowSide:h[y.side],L.alphaMap=y.alphaMap,L.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,L.map=y.map,L.clipShadows=y.clipShadows,L.clippingPlanes=y.clippingPlanes,L.clipIntersection=y.clipIntersection,L.displacementMap=y.displacementMap,L.displacementScale=y.displacementScale,L.displacementBias=y.displacementBias,L.wireframeLinewidth=y.wireframeLinewidth,L.linewidth=y.linewidth,M.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let D=n.properties.get(L);D.light=M}return L}function v(A,y,M,I,L,C){if(A.visible===!1)return;if(A.layers.test(L)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&C===bo)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(M.matrixWorldInverse,A.matrixWorld);let N=e.update(A),B=A.material;if(Array.isArray(B)){let $=N.groups;for(let H=0,se=$.length;H<se;H++){let Y=$[H],Q=B[Y.materialIndex];if(Q&&Q.visible){let ie=b(A,Q,I,C);A.onBeforeShadow(n,A,y,M,N,ie,Y),n.renderBufferDirect(M,null,N,ie,A,Y),A.onAfterShadow(n,A,y,M,N,ie,Y)}}}else if(B.visible){let $=b(A,B,I,C);A.onBeforeShadow(n,A,y,M,N,$,null),n.renderBufferDirect(M,null,N,$,A,null),A.onAfterShadow(n,A,y,M,N,$,null)}}let k=A.children;for(let N=0,B=k.length;N<B;N++)v(k[N],y,M,I,L,C)}function E(A){A.target.removeEventListener("dispose",E);for(let M in c){let I=c[M],L=A.target.uuid;L in I&&(I[L].dispose(),delete I[L])}}}function aA(n,e){function t(){let z=!1,oe=new Ft,ne=null,Ae=new Ft(0,0,0,0);return{setMask:function(xe){ne!==xe&&!z&&(n.colorMask(xe,xe,xe,xe),ne=xe)},setLocked:function(xe){z=xe},setClear:function(xe,be,Ge,Je,ce){ce===!0&&(xe*=Je,be*=Je,Ge*=Je),oe.set(xe,be,Ge,Je),Ae.equals(oe)===!1&&(n.clearColor(xe,be,Ge,Je),Ae.copy(oe))},reset:function(){z=!1,ne=null,Ae.set(-1,0,0,0)}}}function i(){let z=!1,oe=!1,ne=null,Ae=null,xe=null;return{setReversed:function(be){if(oe!==be){let Ge=e.get("EXT_clip_control");be?Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.ZERO_TO_ONE_EXT):Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.NEGATIVE_ONE_TO_ONE_EXT),oe=be;let Je=xe;xe=null,this.setClear(Je)}},getReversed:function(){return oe},setTest:function(be){be?Me(n.DEPTH_TEST):He(n.DEPTH_TEST)},setMask:function(be){ne!==be&&!z&&(n.depthMask(be),ne=be)},setFunc:function(be){if(oe&&(be=hg[be]),Ae!==be){switch(be){case Gl:n.depthFunc(n.NEVER);break;case Hl:n.depthFunc(n.ALWAYS);break;case Wl:n.depthFunc(n.LESS);break;case co:n.depthFunc(n.LEQUAL);break;case $l:n.depthFunc(n.EQUAL);break;case Xl:n.depthFunc(n.GEQUAL);break;case ql:n.depthFunc(n.GREATER);break;case Yl:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ae=be}},setLocked:function(be){z=be},setClear:function(be){xe!==be&&(xe=be,oe&&(be=1-be),n.clearDepth(be))},reset:function(){z=!1,ne=null,Ae=null,xe=null,oe=!1}}}function s(){let z=!1,oe=null,ne=null,Ae=null,xe=null,be=null,Ge=null,Je=null,ce=null;return{setTest:function(ke){z||(ke?Me(n.STENCIL_TEST):He(n.STENCIL_TEST))},setMask:function(ke){oe!==ke&&!z&&(n.stencilMask(ke),oe=ke)},setFunc:function(ke,je,Ce){(ne!==ke||Ae!==je||xe!==Ce)&&(n.stencilFunc(ke,je,Ce),ne=ke,Ae=je,xe=Ce)},setOp:function(ke,je,Ce){(be!==ke||Ge!==je||Je!==Ce)&&(n.stencilOp(ke,je,Ce),be=ke,Ge=je,Je=Ce)},setLocked:function(ke){z=ke},setClear:function(ke){ce!==ke&&(n.clearStencil(ke),ce=ke)},reset:function(){z=!1,oe=null,ne=null,Ae=null,xe=null,be=null,Ge=null,Je=null,ce=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,p=[],x=null,g=!1,m=null,_=null,b=null,v=null,E=null,A=null,y=null,M=new $e(0,0,0),I=0,L=!1,C=null,D=null,k=null,N=null,B=null,$=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,se=0,Y=n.getParameter(n.VERSION);Y.indexOf("WebGL")!==-1?(se=parseFloat(/^WebGL (\d)/.exec(Y)[1]),H=se>=1):Y.indexOf("OpenGL ES")!==-1&&(se=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),H=se>=2);let Q=null,ie={},fe=n.getParameter(n.SCISSOR_BOX),de=n.getParameter(n.VIEWPORT),ee=new Ft().fromArray(fe),he=new Ft().fromArray(de);function ge(z,oe,ne,Ae){let xe=new Uint8Array(4),be=n.createTexture();n.bindTexture(z,be),n.texParameteri(z,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(z,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Ge=0;Ge<ne;Ge++)z===n.TEXTURE_3D||z===n.TEXTURE_2D_ARRAY?n.texImage3D(oe,0,n.RGBA,1,1,Ae,0,n.RGBA,n.UNSIGNED_BYTE,xe):n.texImage2D(oe+Ge,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,xe);return be}let Se={};Se[n.TEXTURE_2D]=ge(n.TEXTURE_2D,n.TEXTURE_2D,1),Se[n.TEXTURE_CUBE_MAP]=ge(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Se[n.TEXTURE_2D_ARRAY]=ge(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Se[n.TEXTURE_3D]=ge(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Me(n.DEPTH_TEST),o.setFunc(co),cn(!1),Nt(cd),Me(n.CULL_FACE),Zt(Mr);function Me(z){u[z]!==!0&&(n.enable(z),u[z]=!0)}function He(z){u[z]!==!1&&(n.disable(z),u[z]=!1)}function st(z,oe){return d[z]!==oe?(n.bindFramebuffer(z,oe),d[z]=oe,z===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=oe),z===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=oe),!0):!1}function Ve(z,oe){let ne=p,Ae=!1;if(z){ne=f.get(oe),ne===void 0&&(ne=[],f.set(oe,ne));let xe=z.textures;if(ne.length!==xe.length||ne[0]!==n.COLOR_ATTACHMENT0){for(let be=0,Ge=xe.length;be<Ge;be++)ne[be]=n.COLOR_ATTACHMENT0+be;ne.length=xe.length,Ae=!0}}else ne[0]!==n.BACK&&(ne[0]=n.BACK,Ae=!0);Ae&&n.drawBuffers(ne)}function ht(z){return x!==z?(n.useProgram(z),x=z,!0):!1}let lt={[wr]:n.FUNC_ADD,[Nm]:n.FUNC_SUBTRACT,[Dm]:n.FUNC_REVERSE_SUBTRACT};lt[Om]=n.MIN,lt[Um]=n.MAX;let nt={[km]:n.ZERO,[Fm]:n.ONE,[Bm]:n.SRC_COLOR,[fd]:n.SRC_ALPHA,[$m]:n.SRC_ALPHA_SATURATE,[Hm]:n.DST_COLOR,[Vm]:n.DST_ALPHA,[zm]:n.ONE_MINUS_SRC_COLOR,[pd]:n.ONE_MINUS_SRC_ALPHA,[Wm]:n.ONE_MINUS_DST_COLOR,[Gm]:n.ONE_MINUS_DST_ALPHA,[Xm]:n.CONSTANT_COLOR,[qm]:n.ONE_MINUS_CONSTANT_COLOR,[Ym]:n.CONSTANT_ALPHA,[Zm]:n.ONE_MINUS_CONSTANT_ALPHA};function Zt(z,oe,ne,Ae,xe,be,Ge,Je,ce,ke){if(z===Mr){g===!0&&(He(n.BLEND),g=!1);return}if(g===!1&&(Me(n.BLEND),g=!0),z!==Lm){if(z!==m||ke!==L){if((_!==wr||E!==wr)&&(n.blendEquation(n.FUNC_ADD),_=wr,E=wr),ke)switch(z){case So:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case ud:n.blendFunc(n.ONE,n.ONE);break;case hd:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case dd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:Qe("WebGLState: Invalid blending: ",z);break}else switch(z){case So:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case ud:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case hd:Qe("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case dd:Qe("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Qe("WebGLState: Invalid blending: ",z);break}b=null,v=null,A=null,y=null,M.set(0,0,0),I=0,m=z,L=ke}return}xe=xe||oe,be=be||ne,Ge=Ge||Ae,(oe!==_||xe!==E)&&(n.blendEquationSeparate(lt[oe],lt[xe]),_=oe,E=xe),(ne!==b||Ae!==v||be!==A||Ge!==y)&&(n.blendFuncSeparate(nt[ne],nt[Ae],nt[be],nt[Ge]),b=ne,v=Ae,A=be,y=Ge),(Je.equals(M)===!1||ce!==I)&&(n.blendColor(Je.r,Je.g,Je.b,ce),M.copy(Je),I=ce),m=z,L=!1}function Vt(z,oe){z.side===zn?He(n.CULL_FACE):Me(n.CULL_FACE);let ne=z.side===Kn;oe&&(ne=!ne),cn(ne),z.blending===So&&z.transparent===!1?Zt(Mr):Zt(z.blending,z.blendEquation,z.blendSrc,z.blendDst,z.blendEquationAlpha,z.blendSrcAlpha,z.blendDstAlpha,z.blendColor,z.blendAlpha,z.premultipliedAlpha),o.setFunc(z.depthFunc),o.setTest(z.depthTest),o.setMask(z.depthWrite),r.setMask(z.colorWrite);let Ae=z.stencilWrite;a.setTest(Ae),Ae&&(a.setMask(z.stencilWriteMask),a.setFunc(z.stencilFunc,z.stencilRef,z.stencilFuncMask),a.setOp(z.stencilFail,z.stencilZFail,z.stencilZPass)),vt(z.polygonOffset,z.polygonOffsetFactor,z.polygonOffsetUnits),z.alphaToCoverage===!0?Me(n.SAMPLE_ALPHA_TO_COVERAGE):He(n.SAMPLE_ALPHA_TO_COVERAGE)}function cn(z){C!==z&&(z?n.frontFace(n.CW):n.frontFace(n.CCW),C=z)}function Nt(z){z!==Rm?(Me(n.CULL_FACE),z!==D&&(z===cd?n.cullFace(n.BACK):z===Pm?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):He(n.CULL_FACE),D=z}function An(z){z!==k&&(H&&n.lineWidth(z),k=z)}function vt(z,oe,ne){z?(Me(n.POLYGON_OFFSET_FILL),(N!==oe||B!==ne)&&(N=oe,B=ne,o.getReversed()&&(oe=-oe,ne=-ne),n.polygonOffset(oe,ne))):He(n.POLYGON_OFFSET_FILL)}function xn(z){z?Me(n.SCISSOR_TEST):He(n.SCISSOR_TEST)}function jt(z){z===void 0&&(z=n.TEXTURE0+$-1),Q!==z&&(n.activeTexture(z),Q=z)}function un(z,oe,ne){ne===void 0&&(Q===null?ne=n.TEXTURE0+$-1:ne=Q);let Ae=ie[ne];Ae===void 0&&(Ae={type:void 0,texture:void 0},ie[ne]=Ae),(Ae.type!==z||Ae.texture!==oe)&&(Q!==ne&&(n.activeTexture(ne),Q=ne),n.bindTexture(z,oe||Se[z]),Ae.type=z,Ae.texture=oe)}function V(){let z=ie[Q];z!==void 0&&z.type!==void 0&&(n.bindTexture(z.type,null),z.type=void 0,z.texture=void 0)}function Re(){try{n.compressedTexImage2D(...arguments)}catch(z){Qe("WebGLState:",z)}}function Ze(){try{n.compressedTexImage3D(...arguments)}catch(z){Qe("WebGLState:",z)}}function rt(){try{n.texSubImage2D(...arguments)}catch(z){Qe("WebGLState:",z)}}function we(){try{n.texSubImage3D(...arguments)}catch(z){Qe("WebGLState:",z)}}function kt(){try{n.compressedTexSubImage2D(...arguments)}catch(z){Qe("WebGLState:",z)}}function ze(){try{n.compressedTexSubImage3D(...arguments)}catch(z){Qe("WebGLState:",z)}}function Xe(){try{n.texStorage2D(...arguments)}catch(z){Qe("WebGLState:",z)}}function O(){try{n.texStorage3D(...arguments)}catch(z){Qe("WebGLState:",z)}}function T(){try{n.texImage2D(...arguments)}catch(z){Qe("WebGLState:",z)}}function q(){try{n.texImage3D(...arguments)}catch(z){Qe("WebGLState:",z)}}function ue(z){return h[z]!==void 0?h[z]:n.getParameter(z)}function ae(z,oe){h[z]!==oe&&(n.pixelStorei(z,oe),h[z]=oe)}function _e(z){ee.equals(z)===!1&&(n.scissor(z.x,z.y,z.z,z.w),ee.copy(z))}function ye(z){he.equals(z)===!1&&(n.viewport(z.x,z.y,z.z,z.w),he.copy(z))}function te(z,oe){let ne=c.get(oe);ne===void 0&&(ne=new WeakMap,c.set(oe,ne));let Ae=ne.get(z);Ae===void 0&&(Ae=n.getUniformBlockIndex(oe,z.name),n.uniformBlockBinding(oe,Ae,Ae),ne.set(z,Ae))}function re(z,oe,ne){let xe=c.get(oe).get(z);l[xe]!==ne&&(n.bindBufferBase(n.UNIFORM_BUFFER,xe,ne),l[xe]=ne)}function me(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},Q=null,ie={},d={},l={},f=new WeakMap,p=[],x=null,g=!1,m=null,_=null,b=null,v=null,E=null,A=null,y=null,M=new $e(0,0,0),I=0,L=!1,C=null,D=null,k=null,N=null,B=null,ee.set(0,0,n.canvas.width,n.canvas.height),he.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Me,disable:He,bindFramebuffer:st,drawBuffers:Ve,useProgram:ht,setBlending:Zt,setMaterial:Vt,setFlipSided:cn,setCullFace:Nt,setLineWidth:An,setPolygonOffset:vt,setScissorTest:xn,activeTexture:jt,bindTexture:un,unbindTexture:V,compressedTexImage2D:Re,compressedTexImage3D:Ze,texImage2D:T,texImage3D:q,pixelStorei:ae,getParameter:ue,updateUBOMapping:te,uniformBlockBinding:re,texStorage2D:Xe,texStorage3D:O,texSubImage2D:rt,texSubImage3D:we,compressedTexSubImage2D:kt,compressedTexSubImage3D:ze,scissor:_e,viewport:ye,reset:me}}function lA(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ye,u=new WeakMap,h=new Set,d,f=new WeakMap,p=new Set,x=new FinalizationRegistry(O=>p.delete(O)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(O,T){return g?new OffscreenCanvas(O,T):ga("canvas")}function _(O,T,q){let ue=1,ae=Xe(O);if((ae.width>q||ae.height>q)&&(ue=q/Math.max(ae.width,ae.height)),ue<1)if(typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&O instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&O instanceof ImageBitmap||typeof VideoFrame<"u"&&O instanceof VideoFrame){let _e=Math.floor(ue*ae.width),ye=Math.floor(ue*ae.height);d===void 0&&(d=m(_e,ye));let te=T?m(_e,ye):d;return te.width=_e,te.height=ye,te.getContext("2d").drawImage(O,0,0,_e,ye),qe("WebGLRenderer: Texture has been resized from ("+ae.width+"x"+ae.height+") to ("+_e+"x"+ye+")."),te}else return"data"in O&&qe("WebGLRenderer: Image in DataTexture is too big ("+ae.width+"x"+ae.height+")."),O;return O}function b(O){return O.generateMipmaps}function v(O){n.generateMipmap(O)}function E(O){return O.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:O.isWebGL3DRenderTarget?n.TEXTURE_3D:O.isWebGLArrayRenderTarget||O.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function A(O,T,q,ue,ae,_e=!1){if(O!==null){if(n[O]!==void 0)return n[O];qe("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+O+"'")}let ye;ue&&(ye=e.get("EXT_texture_norm16"),ye||qe("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=T;if(T===n.RED&&(q===n.FLOAT&&(te=n.R32F),q===n.HALF_FLOAT&&(te=n.R16F),q===n.UNSIGNED_BYTE&&(te=n.R8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.R16_EXT),q===n.SHORT&&ye&&(te=ye.R16_SNORM_EXT)),T===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.R8UI),q===n.UNSIGNED_SHORT&&(te=n.R16UI),q===n.UNSIGNED_INT&&(te=n.R32UI),q===n.BYTE&&(te=n.R8I),q===n.SHORT&&(te=n.R16I),q===n.INT&&(te=n.R32I)),T===n.RG&&(q===n.FLOAT&&(te=n.RG32F),q===n.HALF_FLOAT&&(te=n.RG16F),q===n.UNSIGNED_BYTE&&(te=n.RG8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.RG16_EXT),q===n.SHORT&&ye&&(te=ye.RG16_SNORM_EXT)),T===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RG8UI),q===n.UNSIGNED_SHORT&&(te=n.RG16UI),q===n.UNSIGNED_INT&&(te=n.RG32UI),q===n.BYTE&&(te=n.RG8I),q===n.SHORT&&(te=n.RG16I),q===n.INT&&(te=n.RG32I)),T===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGB8UI),q===n.UNSIGNED_SHORT&&(te=n.RGB16UI),q===n.UNSIGNED_INT&&(te=n.RGB32UI),q===n.BYTE&&(te=n.RGB8I),q===n.SHORT&&(te=n.RGB16I),q===n.INT&&(te=n.RGB32I)),T===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),q===n.UNSIGNED_INT&&(te=n.RGBA32UI),q===n.BYTE&&(te=n.RGBA8I),q===n.SHORT&&(te=n.RGBA16I),q===n.INT&&(te=n.RGBA32I)),T===n.RGB&&(q===n.UNSIGNED_SHORT&&ye&&(te=ye.RGB16_EXT),q===n.SHORT&&ye&&(te=ye.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),T===n.RGBA){let re=_e?ma:xt.getTransfer(ae);q===n.FLOAT&&(te=n.RGBA32F),q===n.HALF_FLOAT&&(te=n.RGBA16F),q===n.UNSIGNED_BYTE&&(te=re===Tt?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.RGBA16_EXT),q===n.SHORT&&ye&&(te=ye.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function y(O,T){let q;return O?T===null||T===Ii||T===Er?q=n.DEPTH24_STENCIL8:T===bi?q=n.DEPTH32F_STENCIL8:T===wo&&(q=n.DEPTH24_STENCIL8,qe("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):T===null||T===Ii||T===Er?q=n.DEPTH_COMPONENT24:T===bi?q=n.DEPTH_COMPONENT32F:T===wo&&(q=n.DEPTH_COMPONENT16),q}function M(O,T){return b(O)===!0||O.isFramebufferTexture&&O.minFilter!==In&&O.minFilter!==Zn?Math.log2(Math.max(T.width,T.height))+1:O.mipmaps.length>0?O.mipmaps.length:O.isCompressedTexture&&Array.isArray(O.image)?T.mipmaps.length:1}function I(O){let T=new WeakRef(O);i.get(O).__ref=T,p.add(T),x.register(O,T,T)}function L(O){let T=i.get(O).__ref;T!==void 0&&(p.delete(T),x.unregister(T))}function C(O){k(O.target)}function D(O){N(O.target)}function k(O){O.removeEventListener("dispose",C),L(O),$(O),O.isVideoTexture&&u.delete(O),O.isHTMLTexture&&h.delete(O)}function N(O){O.removeEventListener("dispose",D),L(O),se(O)}function B(){for(let O of p){let T=O.deref();T!==void 0&&(T.isRenderTarget===!0?N(T):k(T))}p.clear(),h.clear()}function $(O){let T=i.get(O);if(T.__webglInit===void 0)return;let q=O.source,ue=f.get(q);if(ue){let ae=ue[T.__cacheKey];ae.usedTimes--,ae.usedTimes===0&&H(O),Object.keys(ue).length===0&&f.delete(q)}i.remove(O)}function H(O){let T=i.get(O);n.deleteTexture(T.__webglTexture);let q=O.source,ue=f.get(q);delete ue[T.__cacheKey],o.memory.textures--}function se(O){let T=i.get(O);T.__depthDisposeCallback&&T.__depthDisposeCallback();let q=O.depthTexture;if(q&&q.renderTarget===O&&k(q),O.isWebGLCubeRenderTarget)for(let ae=0;ae<6;ae++){if(Array.isArray(T.__webglFramebuffer[ae]))for(let _e=0;_e<T.__webglFramebuffer[ae].length;_e++)n.deleteFramebuffer(T.__webglFramebuffer[ae][_e]);else n.deleteFramebuffer(T.__webglFramebuffer[ae]);T.__webglDepthbuffer&&n.deleteRenderbuffer(T.__webglDepthbuffer[ae])}else{if(Array.isArray(T.__webglFramebuffer))for(let ae=0;ae<T.__webglFramebuffer.length;ae++)n.deleteFramebuffer(T.__webglFramebuffer[ae]);else n.deleteFramebuffer(T.__webglFramebuffer);if(T.__webglDepthbuffer&&n.deleteRenderbuffer(T.__webglDepthbuffer),T.__webglMultisampledFramebuffer&&n.deleteFramebuffer(T.__webglMultisampledFramebuffer),T.__webglColorRenderbuffer)for(let ae=0;ae<T.__webglColorRenderbuffer.length;ae++)T.__webglColorRenderbuffer[ae]&&n.deleteRenderbuffer(T.__webglColorRenderbuffer[ae]);T.__webglDepthRenderbuffer&&n.deleteRenderbuffer(T.__webglDepthRenderbuffer)}let ue=O.textures;for(let ae=0,_e=ue.length;ae<_e;ae++){let ye=i.get(ue[ae]);ye.__webglTexture&&(n.deleteTexture(ye.__webglTexture),o.memory.textures--),i.remove(ue[ae])}i.remove(O)}let Y=0;function Q(){Y=0}function ie(){return Y}function fe(O){Y=O}function de(){let O=Y;return O>=s.maxTextures&&qe("WebGLTextures: Trying to use "+(O+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,O}function ee(O){let T=[];return T.push(O.wrapS),T.push(O.wrapT),T.push(O.wrapR||0),T.push(O.magFilter),T.push(O.minFilter),T.push(O.anisotropy),T.push(O.internalFormat),T.push(O.format),T.push(O.type),T.push(O.generateMipmaps),T.push(O.mipmapsAutoUpdate),T.push(O.premultiplyAlpha),T.push(O.flipY),T.push(O.unpackAlignment),T.push(O.colorSpace),T.join()}function he(O,T){let q=i.get(O);if(O.isVideoTexture&&kt(O),O.isRenderTargetTexture===!1&&O.isExternalTexture!==!0&&O.version>0&&q.__version!==O.version){let ue=O.image;if(ue===null)qe("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)qe("WebGLRenderer: Texture marked for update but image is incomplete");else{Vt(q,O,T);return}}else O.isExternalTexture&&(q.__webglTexture=O.sourceTexture?O.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+T)}function ge(O,T){let q=i.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&q.__version!==O.version){Vt(q,O,T);return}else O.isExternalTexture&&(q.__webglTexture=O.sourceTexture?O.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+T)}function Se(O,T){let q=i.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&q.__version!==O.version){Vt(q,O,T);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+T)}function Me(O,T){let q=i.get(O);if(O.version>0&&q.__version!==O.version){cn(q,O,T);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+T)}let He={[Zl]:n.REPEAT,[Ki]:n.CLAMP_TO_EDGE,[Kl]:n.MIRRORED_REPEAT},st={[In]:n.NEAREST,[jm]:n.NEAREST_MIPMAP_NEAREST,[Ua]:n.NEAREST_MIPMAP_LINEAR,[Zn]:n.LINEAR,[Mc]:n.LINEAR_MIPMAP_NEAREST,[Ms]:n.LINEAR_MIPMAP_LINEAR},Ve={[ng]:n.NEVER,[Nd]:n.ALWAYS,[ig]:n.LESS,[Id]:n.LEQUAL,[sg]:n.EQUAL,[Ld]:n.GEQUAL,[rg]:n.GREATER,[og]:n.NOTEQUAL};function ht(O,T){if(T.type===bi&&e.has("OES_texture_float_linear")===!1&&(T.magFilter===Zn||T.magFilter===Mc||T.magFilter===Ua||T.magFilter===Ms||T.minFilter===Zn||T.minFilter===Mc||T.minFilter===Ua||T.minFilter===Ms)&&qe("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(O,n.TEXTURE_WRAP_S,He[T.wrapS]),n.texParameteri(O,n.TEXTURE_WRAP_T,He[T.wrapT]),(O===n.TEXTURE_3D||O===n.TEXTURE_2D_ARRAY)&&n.texParameteri(O,n.TEXTURE_WRAP_R,He[T.wrapR]),n.texParameteri(O,n.TEXTURE_MAG_FILTER,st[T.magFilter]),n.texParameteri(O,n.TEXTURE_MIN_FILTER,st[T.minFilter]),T.compareFunction&&(n.texParameteri(O,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(O,n.TEXTURE_COMPARE_FUNC,Ve[T.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(T.magFilter===In||T.minFilter!==Ua&&T.minFilter!==Ms||T.type===bi&&e.has("OES_texture_float_linear")===!1)return;if(T.anisotropy>1||i.get(T).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(O,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(T.anisotropy,s.getMaxAnisotropy())),i.get(T).__currentAnisotropy=T.anisotropy}}}function lt(O,T){let q=!1;O.__webglInit===void 0&&(O.__webglInit=!0,T.addEventListener("dispose",C),I(T));let ue=T.source,ae=f.get(ue);ae===void 0&&(ae={},f.set(ue,ae));let _e=ee(T);if(_e!==O.__cacheKey){ae[_e]===void 0&&(ae[_e]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),ae[_e].usedTimes++;let ye=ae[O.__cacheKey];ye!==void 0&&(ae[O.__cacheKey].usedTimes--,ye.usedTimes===0&&H(T)),O.__cacheKey=_e,O.__webglTexture=ae[_e].texture}return q}function nt(O,T,q){return Math.floor(Math.floor(O/q)/T)}function Zt(O,T,q,ue){let _e=O.updateRanges;if(_e.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,T.width,T.height,q,ue,T.data);else{_e.sort((z,oe)=>z.start-oe.start);let ye=0;for(let z=1;z<_e.length;z++){let oe=_e[ye],ne=_e[z],Ae=oe.start+oe.count,xe=nt(ne.start,T.width,4),be=nt(oe.start,T.width,4);ne.start<=Ae+1&&xe===be&&nt(ne.start+ne.count-1,T.width,4)===xe?oe.count=Math.max(oe.count,ne.start+ne.count-oe.start):(++ye,_e[ye]=ne)}_e.length=ye+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),re=t.getParameter(n.UNPACK_SKIP_PIXELS),me=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,T.width);for(let z=0,oe=_e.length;z<oe;z++){let ne=_e[z],Ae=Math.floor(ne.start/4),xe=Math.ceil(ne.count/4),be=Ae%T.width,Ge=Math.floor(Ae/T.width),Je=xe,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,be),t.pixelStorei(n.UNPACK_SKIP_ROWS,Ge),t.texSubImage2D(n.TEXTURE_2D,0,be,Ge,Je,ce,q,ue,T.data)}O.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,re),t.pixelStorei(n.UNPACK_SKIP_ROWS,me)}}function Vt(O,T,q){let ue=n.TEXTURE_2D;(T.isDataArrayTexture||T.isCompressedArrayTexture)&&(ue=n.TEXTURE_2D_ARRAY),T.isData3DTexture&&(ue=n.TEXTURE_3D);let ae=lt(O,T),_e=T.source;t.bindTexture(ue,O.__webglTexture,n.TEXTURE0+q);let ye=i.get(_e);if(_e.version!==ye.__version||ae===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&T.image instanceof ImageBitmap)===!1){let ce=xt.getPrimaries(xt.workingColorSpace),ke=T.colorSpace===As?null:xt.getPrimaries(T.colorSpace),je=T.colorSpace===As||ce===ke?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,T.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,je)}t.pixelStorei(n.UNPACK_ALIGNMENT,T.unpackAlignment);let re=_(T.image,!1,s.maxTextureSize);re=ze(T,re);let me=r.convert(T.format,T.colorSpace),z=r.convert(T.type),oe=A(T.internalFormat,me,z,T.normalized,T.colorSpace,T.isVideoTexture);ht(ue,T);let ne,Ae=T.mipmaps,xe=T.isVideoTexture!==!0,be=ye.__version===void 0||ae===!0,Ge=_e.dataReady,Je=M(T,re);if(T.isDepthTexture)oe=y(T.format===ws,T.type),be&&(xe?t.texStorage2D(n.TEXTURE_2D,1,oe,re.width,re.height):t.texImage2D(n.TEXTURE_2D,0,oe,re.width,re.height,0,me,z,null));else if(T.isDataTexture)if(Ae.length>0){xe&&be&&t.texStorage2D(n.TEXTURE_2D,Je,oe,Ae[0].width,Ae[0].height);for(let ce=0,ke=Ae.length;ce<ke;ce++)ne=Ae[ce],xe?Ge&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,me,z,ne.data):t.texImage2D(n.TEXTURE_2D,ce,oe,ne.width,ne.height,0,me,z,ne.data);T.generateMipmaps=!1}else xe?(be&&t.texStorage2D(n.TEXTURE_2D,Je,oe,re.width,re.height),Ge&&Zt(T,re,me,z)):t.texImage2D(n.TEXTURE_2D,0,oe,re.width,re.height,0,me,z,re.data);else if(T.isCompressedTexture)if(T.isCompressedArrayTexture){xe&&be&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Je,oe,Ae[0].width,Ae[0].height,re.depth);for(let ce=0,ke=Ae.length;ce<ke;ce++)if(ne=Ae[ce],T.format!==Ni)if(me!==null)if(xe){if(Ge)if(T.layerUpdates.size>0){let je=Hd(ne.width,ne.height,T.format,T.type);for(let Ce of T.layerUpdates){let ot=ne.data.subarray(Ce*je/ne.data.BYTES_PER_ELEMENT,(Ce+1)*je/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Ce,ne.width,ne.height,1,me,ot)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,re.depth,me,ne.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,oe,ne.width,ne.height,re.depth,0,ne.data,0,0);else qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xe?Ge&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,re.depth,me,z,ne.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,oe,ne.width,ne.height,re.depth,0,me,z,ne.data);T.layerUpdates.size>0&&T.clearLayerUpdates()}else{xe&&be&&t.texStorage2D(n.TEXTURE_2D,Je,oe,Ae[0].width,Ae[0].height);for(let ce=0,ke=Ae.length;ce<ke;ce++)ne=Ae[ce],T.format!==Ni?me!==null?xe?Ge&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,me,ne.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,oe,ne.width,ne.height,0,ne.data):qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xe?Ge&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,me,z,ne.data):t.texImage2D(n.TEXTURE_2D,ce,oe,ne.width,ne.height,0,me,z,ne.data)}else if(T.isDataArrayTexture)if(xe){if(be&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Je,oe,re.width,re.height,re.depth),Ge)if(T.layerUpdates.size>0){let ce=Hd(re.width,re.height,T.format,T.type);for(let ke of T.layerUpdates){let je=re.data.subarray(ke*ce/re.data.BYTES_PER_ELEMENT,(ke+1)*ce/re.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,ke,re.width,re.height,1,me,z,je)}T.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,re.width,re.height,re.depth,me,z,re.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,oe,re.width,re.height,re.depth,0,me,z,re.data);else if(T.isData3DTexture)xe?(be&&t.texStorage3D(n.TEXTURE_3D,Je,oe,re.width,re.height,re.depth),Ge&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,re.width,re.height,re.depth,me,z,re.data)):t.texImage3D(n.TEXTURE_3D,0,oe,re.width,re.height,re.depth,0,me,z,re.data);else if(T.isFramebufferTexture){if(be)if(xe)t.texStorage2D(n.TEXTURE_2D,Je,oe,re.width,re.height);else{let ce=re.width,ke=re.height;for(let je=0;je<Je;je++)t.texImage2D(n.TEXTURE_2D,je,oe,ce,ke,0,me,z,null),ce>>=1,ke>>=1}}else if(T.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),re.parentNode!==ce){ce.appendChild(re),h.add(T),ce.onpaint=ke=>{let je=ke.changedElements;for(let Ce of h)je.includes(Ce.image)&&(Ce.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,re);else{let je=n.RGBA,Ce=n.RGBA,ot=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,je,Ce,ot,re)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ae.length>0){if(xe&&be){let ce=Xe(Ae[0]);t.texStorage2D(n.TEXTURE_2D,Je,oe,ce.width,ce.height)}for(let ce=0,ke=Ae.length;ce<ke;ce++)ne=Ae[ce],xe?Ge&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,me,z,ne):t.texImage2D(n.TEXTURE_2D,ce,oe,me,z,ne);T.generateMipmaps=!1}else if(xe){if(be){let ce=Xe(re);t.texStorage2D(n.TEXTURE_2D,Je,oe,ce.width,ce.height)}Ge&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,me,z,re)}else t.texImage2D(n.TEXTURE_2D,0,oe,me,z,re);b(T)&&T.mipmapsAutoUpdate===!0&&v(ue),ye.__version=_e.version,T.onUpdate&&T.onUpdate(T)}O.__version=T.version}function cn(O,T,q){if(T.image.length!==6)return;let ue=lt(O,T),ae=T.source;t.bindTexture(n.TEXTURE_CUBE_MAP,O.__webglTexture,n.TEXTURE0+q);let _e=i.get(ae);if(ae.version!==_e.__version||ue===!0){t.activeTexture(n.TEXTURE0+q);let ye=xt.getPrimaries(xt.workingColorSpace),te=T.colorSpace===As?null:xt.getPrimaries(T.colorSpace),re=T.colorSpace===As||ye===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,T.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,T.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,re);let me=T.isCompressedTexture||T.image[0].isCompressedTexture,z=T.image[0]&&T.image[0].isDataTexture,oe=[];for(let Ce=0;Ce<6;Ce++)!me&&!z?oe[Ce]=_(T.image[Ce],!0,s.maxCubemapSize):oe[Ce]=z?T.image[Ce].image:T.image[Ce],oe[Ce]=ze(T,oe[Ce]);let ne=oe[0],Ae=r.convert(T.format,T.colorSpace),xe=r.convert(T.type),be=A(T.internalFormat,Ae,xe,T.normalized,T.colorSpace),Ge=T.isVideoTexture!==!0,Je=_e.__version===void 0||ue===!0,ce=ae.dataReady,ke=M(T,ne);ht(n.TEXTURE_CUBE_MAP,T);let je;if(T.isDepthTexture){if(be=y(T.format===ws,T.type),Je)if(Ge)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,be,ne.width,ne.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,ne.width,ne.height,0,Ae,xe,null)}else if(me){Ge&&Je&&t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,be,ne.width,ne.height);for(let Ce=0;Ce<6;Ce++){je=oe[Ce].mipmaps;for(let ot=0;ot<je.length;ot++){let Gt=je[ot];T.format!==Ni?Ae!==null?Ge?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot,0,0,Gt.width,Gt.height,Ae,Gt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot,be,Gt.width,Gt.height,0,Gt.data):qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot,0,0,Gt.width,Gt.height,Ae,xe,Gt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot,be,Gt.width,Gt.height,0,Ae,xe,Gt.data)}}}else{if(je=T.mipmaps,Ge&&Je){je.length>0&&ke++;let Ce=Xe(oe[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,be,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(z){Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,oe[Ce].width,oe[Ce].height,Ae,xe,oe[Ce].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,oe[Ce].width,oe[Ce].height,0,Ae,xe,oe[Ce].data);for(let ot=0;ot<je.length;ot++){let Gn=je[ot].image[Ce].image;Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot+1,0,0,Gn.width,Gn.height,Ae,xe,Gn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot+1,be,Gn.width,Gn.height,0,Ae,xe,Gn.data)}}else{Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,Ae,xe,oe[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,Ae,xe,oe[Ce]);for(let ot=0;ot<je.length;ot++){let Gt=je[ot];Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot+1,0,0,Ae,xe,Gt.image[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot+1,be,Ae,xe,Gt.image[Ce])}}}b(T)&&T.mipmapsAutoUpdate===!0&&v(n.TEXTURE_CUBE_MAP),_e.__version=ae.version,T.onUpdate&&T.onUpdate(T)}O.__version=T.version}function Nt(O,T,q,ue,ae,_e){let ye=r.convert(q.format,q.colorSpace),te=r.convert(q.type),re=A(q.internalFormat,ye,te,q.normalized,q.colorSpace),me=i.get(T),z=i.get(q);if(z.__renderTarget=T,!me.__hasExternalTextures){let oe=Math.max(1,T.width>>_e),ne=Math.max(1,T.height>>_e);ae===n.TEXTURE_3D||ae===n.TEXTURE_2D_ARRAY?t.texImage3D(ae,_e,re,oe,ne,T.depth,0,ye,te,null):t.texImage2D(ae,_e,re,oe,ne,0,ye,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,O),we(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ue,ae,z.__webglTexture,0,rt(T)):(ae===n.TEXTURE_2D||ae>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ae<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ue,ae,z.__webglTexture,_e),t.bindFramebuffer(n.FRAMEBUFFER,null)}function An(O,T,q){if(n.bindRenderbuffer(n.RENDERBUFFER,O),T.depthBuffer){let ue=T.depthTexture,ae=ue&&ue.isDepthTexture?ue.type:null,_e=y(T.stencilBuffer,ae),ye=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;we(T)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,rt(T),_e,T.width,T.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,rt(T),_e,T.width,T.height):n.renderbufferStorage(n.RENDERBUFFER,_e,T.width,T.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ye,n.RENDERBUFFER,O)}else{let ue=T.textures;for(let ae=0;ae<ue.length;ae++){let _e=ue[ae],ye=r.convert(_e.format,_e.colorSpace),te=r.convert(_e.type),re=A(_e.internalFormat,ye,te,_e.normalized,_e.colorSpace);we(T)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,rt(T),re,T.width,T.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,rt(T),re,T.width,T.height):n.renderbufferStorage(n.RENDERBUFFER,re,T.width,T.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function vt(O,T,q){let ue=T.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,O),!(T.depthTexture&&T.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ae=i.get(T.depthTexture);ae.__renderTarget=T;let _e=ue?T.depthTexture.image[0]:T.depthTexture.image;(!ae.__webglTexture||_e.width!==T.width||_e.height!==T.height)&&(_e.width=T.width,_e.height=T.height,T.depthTexture.needsUpdate=!0),ue?Me(T.depthTexture,0):he(T.depthTexture,0);let ye=ae.__webglTexture,te=rt(T),re=ue?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,me=T.depthTexture.format===ws?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(T.depthTexture.format===xs)we(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,me,re,ye,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,me,re,ye,0);else if(T.depthTexture.format===ws)we(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,me,re,ye,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,me,re,ye,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function xn(O){let T=i.get(O),q=O.isWebGLCubeRenderTarget===!0;if(T.__boundDepthTexture!==O.depthTexture){let ue=O.depthTexture;if(T.__depthDisposeCallback&&T.__depthDisposeCallback(),ue){let ae=()=>{delete T.__boundDepthTexture,delete T.__depthDisposeCallback,ue.removeEventListener("dispose",ae)};ue.addEventListener("dispose",ae),T.__depthDisposeCallback=ae}T.__boundDepthTexture=ue}if(O.depthTexture&&!T.__autoAllocateDepthBuffer)if(q)for(let ue=0;ue<6;ue++)vt(T.__webglFramebuffer[ue],O,ue);else O.texture.mipmaps.length>0?vt(T.__webglFramebuffer[0],O,0):vt(T.__webglFramebuffer,O,0);else if(q){T.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer[ue]),T.__webglDepthbuffer[ue]===void 0)T.__webglDepthbuffer[ue]=n.createRenderbuffer(),An(T.__webglDepthbuffer[ue],O,!1);else{let ae=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=T.__webglDepthbuffer[ue];n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,_e)}}else if(O.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer),T.__webglDepthbuffer===void 0)T.__webglDepthbuffer=n.createRenderbuffer(),An(T.__webglDepthbuffer,O,!1);else{let ae=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=T.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,_e)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function jt(O,T,q){let ue=i.get(O);T!==void 0&&Nt(ue.__webglFramebuffer,O,O.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&xn(O)}function un(O){let T=O.texture,q=i.get(O),ue=i.get(T);O.addEventListener("dispose",D),I(O);let ae=O.textures,_e=O.isWebGLCubeRenderTarget===!0,ye=ae.length>1;if(ye||(ue.__webglTexture===void 0&&(ue.__webglTexture=n.createTexture()),ue.__version=T.version,o.memory.textures++),_e){q.__webglFramebuffer=[];for(let te=0;te<6;te++)if(T.mipmaps.length>0){q.__webglFramebuffer[te]=[];for(let re=0;re<T.mipmaps.length;re++)q.__webglFramebuffer[te][re]=n.createFramebuffer()}else q.__webglFramebuffer[te]=n.createFramebuffer()}else{if(T.mipmaps.length>0){q.__webglFramebuffer=[];for(let te=0;te<T.mipmaps.length;te++)q.__webglFramebuffer[te]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(ye)for(let te=0,re=ae.length;te<re;te++){let me=i.get(ae[te]);me.__webglTexture===void 0&&(me.__webglTexture=n.createTexture(),o.memory.textures++)}if(O.samples>0&&we(O)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let te=0;te<ae.length;te++){let re=ae[te];q.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[te]);let me=r.convert(re.format,re.colorSpace),z=r.convert(re.type),oe=A(re.internalFormat,me,z,re.normalized,re.colorSpace,O.isXRRenderTarget===!0),ne=rt(O);n.renderbufferStorageMultisample(n.RENDERBUFFER,ne,oe,O.width,O.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,q.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),O.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),An(q.__webglDepthRenderbuffer,O,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(_e){t.bindTexture(n.TEXTURE_CUBE_MAP,ue.__webglTexture),ht(n.TEXTURE_CUBE_MAP,T);for(let te=0;te<6;te++)if(T.mipmaps.length>0)for(let re=0;re<T.mipmaps.length;re++)Nt(q.__webglFramebuffer[te][re],O,T,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,re);else Nt(q.__webglFramebuffer[te],O,T,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);b(T)?v(n.TEXTURE_CUBE_MAP):T.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),t.unbindTexture()}else if(ye){for(let te=0,re=ae.length;te<re;te++){let me=ae[te],z=i.get(me),oe=n.TEXTURE_2D;(O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(oe=O.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(oe,z.__webglTexture),ht(oe,me),Nt(q.__webglFramebuffer,O,me,n.COLOR_ATTACHMENT0+te,oe,0),b(me)&&v(oe)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(te=O.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,ue.__webglTexture),ht(te,T),T.mipmaps.length>0)for(let re=0;re<T.mipmaps.length;re++)Nt(q.__webglFramebuffer[re],O,T,n.COLOR_ATTACHMENT0,te,re);else Nt(q.__webglFramebuffer,O,T,n.COLOR_ATTACHMENT0,te,0);b(T)?v(te):T.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),t.unbindTexture()}O.depthBuffer&&xn(O)}function V(O){let T=O.textures;for(let q=0,ue=T.length;q<ue;q++){let ae=T[q];if(b(ae)&&ae.mipmapsAutoUpdate===!0){let _e=E(O),ye=i.get(ae).__webglTexture;t.bindTexture(_e,ye),v(_e),t.unbindTexture()}}}let Re=[];function Ze(O){if(O.samples>0){if(we(O)===!1){let T=O.textures,q=O.width,ue=O.height,ae=n.COLOR_BUFFER_BIT,_e=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=i.get(O),te=T.length>1;if(te)for(let me=0;me<T.length;me++)t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ye.__webglMultisampledFramebuffer),O.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer);for(let me=0;me<T.length;me++){if(O.resolveDepthBuffer&&(O.depthBuffer&&(ae|=n.DEPTH_BUFFER_BIT),O.stencilBuffer&&O.resolveStencilBuffer&&(ae|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ye.__webglColorRenderbuffer[me]);let z=i.get(T[me]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,z,0)}n.blitFramebuffer(0,0,q,ue,0,0,q,ue,ae,n.NEAREST),l===!0&&(Re.length=0,Re.push(n.COLOR_ATTACHMENT0+me),O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&Re.push(_e),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Re))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let me=0;me<T.length;me++){t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.RENDERBUFFER,ye.__webglColorRenderbuffer[me]);let z=i.get(T[me]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.TEXTURE_2D,z,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglMultisampledFramebuffer)}else if(O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&l){let T=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[T])}}}function rt(O){return Math.min(s.maxSamples,O.samples)}function we(O){let T=i.get(O);return O.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&T.__useRenderToTexture!==!1}function kt(O){let T=o.render.frame;u.get(O)!==T&&(u.set(O,T),O.update())}function ze(O,T){let q=O.colorSpace,ue=O.format,ae=O.type;return O.isCompressedTexture===!0||O.isVideoTexture===!0||q!==pa&&q!==As&&(xt.getTransfer(q)===Tt?(ue!==Ni||ae!==ei)&&qe("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Qe("WebGLTextures: Unsupported texture color space:",q)),T}function Xe(O){return typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement?(c.width=O.naturalWidth||O.width,c.height=O.naturalHeight||O.height):typeof VideoFrame<"u"&&O instanceof VideoFrame?(c.width=O.displayWidth,c.height=O.displayHeight):(c.width=O.width,c.height=O.height),c}this.allocateTextureUnit=de,this.resetTextureUnits=Q,this.getTextureUnits=ie,this.setTextureUnits=fe,this.setTexture2D=he,this.setTexture2DArray=ge,this.setTexture3D=Se,this.setTextureCube=Me,this.rebindTextures=jt,this.setupRenderTarget=un,this.updateRenderTargetMipmap=V,this.updateMultisampleRenderTarget=Ze,this.setupDepthRenderbuffer=xn,this.setupFrameBufferTexture=Nt,this.useMultisampledRTT=we,this.dispose=B}function cA(n,e){function t(i,s=As){let r,o=xt.getTransfer(s);if(i===ei)return n.UNSIGNED_BYTE;if(i===Ac)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Ec)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Ad)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Ed)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Md)return n.BYTE;if(i===wd)return n.SHORT;if(i===wo)return n.UNSIGNED_SHORT;if(i===wc)return n.INT;if(i===Ii)return n.UNSIGNED_INT;if(i===bi)return n.FLOAT;if(i===Li)return n.HALF_FLOAT;if(i===Td)return n.ALPHA;if(i===Cd)return n.RGB;if(i===Ni)return n.RGBA;if(i===xs)return n.DEPTH_COMPONENT;if(i===ws)return n.DEPTH_STENCIL;if(i===Tc)return n.RED;if(i===Cc)return n.RED_INTEGER;if(i===js)return n.RG;if(i===Rc)return n.RG_INTEGER;if(i===Pc)return n.RGBA_INTEGER;if(i===ka||i===Fa||i===Ba||i===za)if(o===Tt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===ka)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Fa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Ba)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===za)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===ka)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Fa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Ba)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===za)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Ic||i===Lc||i===Nc||i===Dc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Ic)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Lc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Nc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Dc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Oc||i===Uc||i===kc||i===Fc||i===Bc||i===Va||i===zc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Oc||i===Uc)return o===Tt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===kc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Fc)return r.COMPRESSED_R11_EAC;if(i===Bc)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Va)return r.COMPRESSED_RG11_EAC;if(i===zc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Vc||i===Gc||i===Hc||i===Wc||i===$c||i===Xc||i===qc||i===Yc||i===Zc||i===Kc||i===Jc||i===jc||i===Qc||i===eu)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Vc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Gc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Hc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Wc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===$c)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Xc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===qc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Yc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Zc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Kc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Jc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===jc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Qc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===eu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===tu||i===nu||i===iu)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===tu)return o===Tt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===nu)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===iu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===su||i===ru||i===Ga||i===ou)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===su)return r.COMPRESSED_RED_RGTC1_EXT;if(i===ru)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Ga)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===ou)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Er?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var uA=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,hA=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,jd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Aa(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Qi({vertexShader:uA,fragmentShader:hA,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new On(new Ta(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Qd=class extends Pi{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,p=null,x=typeof XRWebGLBinding<"u",g=new jd,m={},_=t.getContextAttributes(),b=null,v=null,E=[],A=[],y=new Ye,M=null,I=null,L=new Yn;L.viewport=new Ft;let C=new Yn;C.viewport=new Ft;let D=[L,C],k=new yc,N=null,B=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let he=E[ee];return he===void 0&&(he=new go,E[ee]=he),he.getTargetRaySpace()},this.getControllerGrip=function(ee){let he=E[ee];return he===void 0&&(he=new go,E[ee]=he),he.getGripSpace()},this.getHand=function(ee){let he=E[ee];return he===void 0&&(he=new go,E[ee]=he),he.getHandSpace()};function $(ee){let he=A.indexOf(ee.inputSource);if(he===-1)return;let ge=E[he];ge!==void 0&&(ge.update(ee.inputSource,ee.frame,c||o),ge.dispatchEvent({type:ee.type,data:ee.inputSource}))}function H(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",se);for(let ee=0;ee<E.length;ee++){let he=A[ee];he!==null&&(A[ee]=null,E[ee].disconnect(he))}N=null,B=null,g.reset();for(let ee in m)delete m[ee];if(e.setRenderTarget(b),f=null,d=null,h=null,s=null,v=null,de.stop(),i.isPresenting=!1,e.setPixelRatio(M),e.setSize(y.width,y.height,!1),I!==null){let ee=I.camera;ee.fov=I.fov,ee.zoom=I.zoom,ee.updateProjectionMatrix(),I=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&qe("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&qe("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&x&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(b=e.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",H),s.addEventListener("inputsourceschange",se),_.xrCompatible!==!0&&await t.makeXRCompatible(),M=e.getPixelRatio(),e.getSize(y),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let ge=null,Se=null,Me=null;_.depth&&(Me=_.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ge=_.stencil?ws:xs,Se=_.stencil?Er:Ii);let He={colorFormat:t.RGBA8,depthFormat:Me,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(He),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),v=new hi(d.textureWidth,d.textureHeight,{format:Ni,type:ei,depthTexture:new bs(d.textureWidth,d.textureHeight,Se,void 0,void 0,void 0,void 0,void 0,void 0,ge),stencilBuffer:_.stencil,colorSpace:e.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let ge={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,ge),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),v=new hi(f.framebufferWidth,f.framebufferHeight,{format:Ni,type:ei,colorSpace:e.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),de.setContext(s),de.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function se(ee){for(let he=0;he<ee.removed.length;he++){let ge=ee.removed[he],Se=A.indexOf(ge);Se>=0&&(A[Se]=null,E[Se].disconnect(ge))}for(let he=0;he<ee.added.length;he++){let ge=ee.added[he],Se=A.indexOf(ge);if(Se===-1){for(let He=0;He<E.length;He++)if(He>=A.length){A.push(ge),Se=He;break}else if(A[He]===null){A[He]=ge,Se=He;break}if(Se===-1)break}let Me=E[Se];Me&&Me.connect(ge)}}function Y(ee,he){he===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(he.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let he=ee.near,ge=ee.far;g.texture!==null&&(g.depthNear>0&&(he=g.depthNear),g.depthFar>0&&(ge=g.depthFar)),k.near=C.near=L.near=he,k.far=C.far=L.far=ge,(N!==k.near||B!==k.far)&&(s.updateRenderState({depthNear:k.near,depthFar:k.far}),N=k.near,B=k.far),k.layers.mask=ee.layers.mask|6,L.layers.mask=k.layers.mask&-5,C.layers.mask=k.layers.mask&-3;let Se=ee.parent,Me=k.cameras;Y(k,Se);for(let He=0;He<Me.length;He++)Y(Me[He],Se);k.projectionMatrix.copy(L.projectionMatrix),k.projectionMatrixInverse.copy(L.projectionMatrixInverse),I===null&&ee.isPerspectiveCamera&&(I={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,k,Se)};function Q(ee,he,ge){ge===null?ee.matrix.copy(he.matrixWorld):(ee.matrix.copy(ge.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(he.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(he.projectionMatrix),ee.projectionMatrixInverse.copy(he.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=fo*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return k},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(ee){l=ee,d!==null&&(d.fixedFoveation=ee),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=ee)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(k)},this.getCameraTexture=function(ee){return m[ee]};let ie=null;function fe(ee,he){if(u=he.getViewerPose(c||o),p=he,u!==null){let ge=u.views;f!==null&&(e.setRenderTargetFramebuffer(v,f.framebuffer),e.setRenderTarget(v));let Se=!1;ge.length!==k.cameras.length&&(k.cameras.length=0,Se=!0);for(let Ve=0;Ve<ge.length;Ve++){let ht=ge[Ve],lt=null;if(f!==null)lt=f.getViewport(ht);else{let Zt=h.getViewSubImage(d,ht);lt=Zt.viewport,Ve===0&&(e.setRenderTargetTextures(v,Zt.colorTexture,Zt.depthStencilTexture),e.setRenderTarget(v))}let nt=D[Ve];nt===void 0&&(nt=new Yn,nt.layers.enable(Ve),nt.viewport=new Ft,D[Ve]=nt),nt.matrix.fromArray(ht.transform.matrix),nt.matrix.decompose(nt.position,nt.quaternion,nt.scale),nt.projectionMatrix.fromArray(ht.projectionMatrix),nt.projectionMatrixInverse.copy(nt.projectionMatrix).invert(),nt.viewport.set(lt.x,lt.y,lt.width,lt.height),Ve===0&&(k.matrix.copy(nt.matrix),k.matrix.decompose(k.position,k.quaternion,k.scale)),Se===!0&&k.cameras.push(nt)}let Me=s.enabledFeatures;if(Me&&Me.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){h=i.getBinding();let Ve=h.getDepthInformation(ge[0]);Ve&&Ve.isValid&&Ve.texture&&g.init(Ve,s.renderState)}if(Me&&Me.includes("camera-access")&&x){e.state.unbindTexture(),h=i.getBinding();for(let Ve=0;Ve<ge.length;Ve++){let ht=ge[Ve].camera;if(ht){let lt=m[ht];lt||(lt=new Aa,m[ht]=lt);let nt=h.getCameraImage(ht);lt.sourceTexture=nt}}}}for(let ge=0;ge<E.length;ge++){let Se=A[ge],Me=E[ge];Se!==null&&Me!==void 0&&Me.update(Se,he,c||o)}ie&&ie(ee,he),he.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:he}),p=null}let de=new Bg;de.setAnimationLoop(fe),this.setAnimationLoop=function(ee){ie=ee},this.dispose=function(){}}},dA=new at,Zg=new et;Zg.set(-1,0,0,0,1,0,0,0,1);function fA(n,e){function t(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function i(g,m){m.color.getRGB(g.fogColor.value,zd(n)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,_,b,v){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),h(g,m)):m.isMeshPhongMaterial?(r(g,m),u(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),d(g,m),m.isMeshPhysicalMaterial&&f(g,m,v)):m.isMeshMatcapMaterial?(r(g,m),p(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),x(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?l(g,m,_,b):m.isSpriteMaterial?c(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,t(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===Kn&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,t(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===Kn&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,t(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,t(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let _=e.get(m),b=_.envMap,v=_.envMapRotation;b&&(g.envMap.value=b,g.envMapRotation.value.setFromMatrix4(dA.makeRotationFromEuler(v)).transpose(),b.isCubeTexture&&b.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(Zg),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function l(g,m,_,b){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*_,g.scale.value=b*.5,m.map&&(g.map.value=m.map,t(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function c(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function u(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function h(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function d(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function f(g,m,_){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Kn&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=_.texture,g.transmissionSamplerSize.value.set(_.width,_.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function x(g,m){let _=e.get(m).light;g.referencePosition.value.setFromMatrixPosition(_.matrixWorld),g.nearDistance.value=_.shadow.camera.near,g.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function pA(n,e,t,i){let s={},r={};function o(_,b){let v=b.program;i.uniformBlockBinding(_,v,s[_.id])}function a(_,b){let v=s[_.id];v===void 0&&(p(_),v=l(_),s[_.id]=v,_.addEventListener("dispose",g));let E=b.program;i.updateUBOMapping(_,E);let A=e.render.frame;r[_.id]!==A&&(c(_),r[_.id]=A)}function l(_){let b=n.createBuffer(),v=_.__size,E=_.usage;return n.bindBuffer(n.UNIFORM_BUFFER,b),n.bufferData(n.UNIFORM_BUFFER,v,E),n.bindBuffer(n.UNIFORM_BUFFER,null),b}function c(_){let b=s[_.id],v=_.uniforms,E=_.__cache;n.bindBuffer(n.UNIFORM_BUFFER,b);for(let A=0,y=v.length;A<y;A++){let M=v[A];if(Array.isArray(M))for(let I=0,L=M.length;I<L;I++)u(M[I],A,I,E);else u(M,A,0,E)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(_,b,v,E){if(d(_,b,v,E)===!0){let A=_.__offset,y=_.value;if(Array.isArray(y)){let M=0;for(let I=0;I<y.length;I++){let L=y[I],C=x(L,!0);h(L,_.__data,M),M+=C.storage/Float32Array.BYTES_PER_ELEMENT}}else h(y,_.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,A,_.__data)}}function h(_,b,v){typeof _=="number"||typeof _=="boolean"?b[v]=_:_.isMatrix3?(b[v]=_.elements[0],b[v+1]=_.elements[1],b[v+2]=_.elements[2],b[v+3]=0,b[v+4]=_.elements[3],b[v+5]=_.elements[4],b[v+6]=_.elements[5],b[v+7]=0,b[v+8]=_.elements[6],b[v+9]=_.elements[7],b[v+10]=_.elements[8],b[v+11]=0):ArrayBuffer.isView(_)?b.set(_.subarray(0,b.length-v),v):_.toArray(b,v)}function d(_,b,v,E){let A=_.value,y=b+"_"+v;if(Array.isArray(A)){E[y]===void 0&&(E[y]=[]);let M=E[y],I=!1;for(let L=0;L<A.length;L++)f(A[L],M,L)===!0&&(I=!0);return I}return f(A,E,y)}function f(_,b,v){if(b[v]===void 0)return typeof _=="number"||typeof _=="boolean"?b[v]=_:ArrayBuffer.isView(_)?b[v]=_.slice():b[v]=_.clone(),!0;{let E=b[v];if(typeof _=="number"||typeof _=="boolean"){if(E!==_)return b[v]=_,!0}else{if(ArrayBuffer.isView(_))return!0;if(E.equals(_)===!1)return E.copy(_),!0}}return!1}function p(_){let b=_.uniforms,v=0,E=16;for(let y=0,M=b.length;y<M;y++){let I=Array.isArray(b[y])?b[y]:[b[y]];for(let L=0,C=I.length;L<C;L++){let D=I[L],k=Array.isArray(D.value)?D.value:[D.value],N=Array.isArray(b[y])||Array.isArray(D.value),B=v;for(let H=0,se=k.length;H<se;H++){let Y=k[H],Q=x(Y,N),ie=v%E,fe=ie%Q.boundary,de=ie+fe;v+=fe,de!==0&&E-de<Q.storage&&(v+=E-de),H===0&&(B=v),v+=Q.storage}let $=D.type==="int"?Int32Array:D.type==="uint"?Uint32Array:Float32Array;D.__data=new $((v-B)/Float32Array.BYTES_PER_ELEMENT),D.__offset=B}}let A=v%E;return A>0&&(v+=E-A),_.__size=v,_.__cache={},this}function x(_,b){let v={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(v.boundary=4,v.storage=4):_.isVector2?(v.boundary=8,v.storage=8):_.isVector3||_.isColor?(v.boundary=16,v.storage=12):_.isVector4?(v.boundary=16,v.storage=16):_.isMatrix3?(v.boundary=16,v.storage=48):_.isMatrix4?(v.boundary=16,v.storage=64):_.isTexture?qe("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(_)?(v.boundary=16,v.storage=_.byteLength):qe("WebGLRenderer: Unsupported uniform value type.",_),b===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function g(_){let b=_.target;b.removeEventListener("dispose",g),n.deleteBuffer(s[b.id]),delete s[b.id],delete r[b.id]}function m(){for(let _ in s)n.deleteBuffer(s[_]);s={},r={}}return{bind:o,update:a,dispose:m}}var mA=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ts=null;function gA(){return ts===null&&(ts=new ba(mA,16,16,js,Li),ts.name="DFG_LUT",ts.minFilter=Zn,ts.magFilter=Zn,ts.wrapS=Ki,ts.wrapT=Ki,ts.generateMipmaps=!1,ts.needsUpdate=!0),ts}var hu=class{constructor(e={}){let{canvas:t=lg(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=ei}=e;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let x=f,g=new Set([Pc,Rc,Cc]),m=new Set([ei,Ii,wo,Er,Ac,Ec]),_=new Uint32Array(4),b=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},E=null,A=null,y=[],M=[],I=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=es,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,C=!1,D=null,k=null,N=null,B=null;this._outputColorSpace=li;let $=0,H=0,se=null,Y=-1,Q=null,ie=new Ft,fe=new Ft,de=null,ee=new $e(0),he=0,ge=t.width,Se=t.height,Me=1,He=null,st=null,Ve=new Ft(0,0,ge,Se),ht=new Ft(0,0,ge,Se),lt=!1,nt=new Ws,Zt=new tc,Vt=!1,cn=!1,Nt=new at,An=new G,vt=new Ft,xn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},jt=!1;function un(){return se===null?Me:1}let V=i;function Re(P,W){return t.getContext(P,W)}let Ze,rt,we,kt,ze,Xe,O,T,q,ue,ae,_e,ye,te,re,me,z,oe,ne,Ae,xe,be,Ge;try{let P={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ke,!1),t.addEventListener("webglcontextrestored",je,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),V===null){let W="webgl2";if(V=Re(W,P),V===null)throw Re(W)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Je()}catch(P){throw t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",je,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),Qe("WebGLRenderer: "+P.message),P}function Je(){Ze=new Tw(V),Ze.init(),xe=new cA(V,Ze),rt=new gw(V,Ze,e,xe),we=new aA(V,Ze),rt.reversedDepthBuffer&&d&&we.buffers.depth.setReversed(!0),k=V.createFramebuffer(),N=V.createFramebuffer(),B=V.createFramebuffer(),kt=new Pw(V),ze=new q1,Xe=new lA(V,Ze,we,ze,rt,xe,kt),O=new Ew(L),T=new Lb(V),be=new pw(V,T),q=new Cw(V,T,kt,be),ue=new Lw(V,q,T,be,kt),oe=new Iw(V,rt,Xe),re=new xw(ze),ae=new X1(L,O,Ze,rt,be,re),_e=new fA(L,ze),ye=new Z1,te=new tA(Ze),z=new fw(L,O,we,ue,p,l),me=new oA(L,ue,rt),Ge=new pA(V,kt,rt,we),ne=new mw(V,Ze,kt),Ae=new Rw(V,Ze,kt),kt.programs=ae.programs,L.capabilities=rt,L.extensions=Ze,L.properties=ze,L.renderLists=ye,L.shadowMap=me,L.state=we,L.info=kt}x!==ei&&(I=new Dw(x,t.width,t.height,a,s,r));let ce=new Qd(L,V);this.xr=ce,this.getContext=function(){return V},this.getContextAttributes=function(){return V.getContextAttributes()},this.forceContextLoss=function(){let P=Ze.get("WEBGL_lose_context");P&&P.loseContext()},this.forceContextRestore=function(){let P=Ze.get("WEBGL_lose_context");P&&P.restoreContext()},this.getPixelRatio=function(){return Me},this.setPixelRatio=function(P){P!==void 0&&(Me=P,this.setSize(ge,Se,!1))},this.getSize=function(P){return P.set(ge,Se)},this.setSize=function(P,W,j=!0){if(ce.isPresenting){qe("WebGLRenderer: Can't change size while VR device is presenting.");return}ge=P,Se=W,t.width=Math.floor(P*Me),t.height=Math.floor(W*Me),j===!0&&(t.style.width=P+"px",t.style.height=W+"px"),I!==null&&I.setSize(t.width,t.height),this.setViewport(0,0,P,W)},this.getDrawingBufferSize=function(P){return P.set(ge*Me,Se*Me).floor()},this.setDrawingBufferSize=function(P,W,j){ge=P,Se=W,Me=j,t.width=Math.floor(P*j),t.height=Math.floor(W*j),this.setViewport(0,0,P,W)},this.setEffects=function(P){if(x===ei){Qe("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(P){for(let W=0;W<P.length;W++)if(P[W].isOutputPass===!0){qe("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}I.setEffects(P||[])},this.getCurrentViewport=function(P){return P.copy(ie)},this.getViewport=function(P){return P.copy(Ve)},this.setViewport=function(P,W,j,Z){P.isVector4?Ve.set(P.x,P.y,P.z,P.w):Ve.set(P,W,j,Z),we.viewport(ie.copy(Ve).multiplyScalar(un()).round())},this.getScissor=function(P){return P.copy(ht)},this.setScissor=function(P,W,j,Z){P.isVector4?ht.set(P.x,P.y,P.z,P.w):ht.set(P,W,j,Z),we.scissor(fe.copy(ht).multiplyScalar(un()).round())},this.getScissorTest=function(){return lt},this.setScissorTest=function(P){we.setScissorTest(lt=P)},this.setOpaqueSort=function(P){He=P},this.setTransparentSort=function(P){st=P},this.getClearColor=function(P){return P.copy(z.getClearColor())},this.setClearColor=function(){z.setClearColor(...arguments)},this.getClearAlpha=function(){return z.getClearAlpha()},this.setClearAlpha=function(){z.setClearAlpha(...arguments)},this.clear=function(P=!0,W=!0,j=!0){let Z=0;if(P){let K=!1;if(se!==null){let Ee=se.texture.format;K=g.has(Ee)}if(K){let Ee=se.texture.type,Pe=m.has(Ee),Te=z.getClearColor(),Ie=z.getClearAlpha(),Be=Te.r,tt=Te.g,dt=Te.b;Pe?(_[0]=Be,_[1]=tt,_[2]=dt,_[3]=Ie,V.clearBufferuiv(V.COLOR,0,_)):(b[0]=Be,b[1]=tt,b[2]=dt,b[3]=Ie,V.clearBufferiv(V.COLOR,0,b))}else Z|=V.COLOR_BUFFER_BIT}W&&(Z|=V.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(Z|=V.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Z!==0&&V.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(P){P.setRenderer(this),D=P},this.dispose=function(){t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",je,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),z.dispose(),ye.dispose(),te.dispose(),Xe.dispose(),ze.dispose(),O.dispose(),ue.dispose(),q.dispose(),be.dispose(),Ge.dispose(),ae.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",hl),ce.removeEventListener("sessionend",Bi),rs.stop()};function ke(P){P.preventDefault(),Od("WebGLRenderer: Context Lost."),C=!0}function je(){Od("WebGLRenderer: Context Restored."),C=!1;let P=kt.autoReset,W=me.enabled,j=me.autoUpdate,Z=me.needsUpdate,K=me.type;Je(),kt.autoReset=P,me.enabled=W,me.autoUpdate=j,me.needsUpdate=Z,me.type=K}function Ce(P){Qe("WebGLRenderer: A WebGL context could not be created. Reason: ",P.statusMessage)}function ot(P){let W=P.target;W.removeEventListener("dispose",ot),Gt(W)}function Gt(P){Gn(P),ze.remove(P)}function Gn(P){let W=ze.get(P).programs;W!==void 0&&(W.forEach(function(j){ae.releaseProgram(j)}),P.isShaderMaterial&&ae.releaseShaderCache(P))}this.renderBufferDirect=function(P,W,j,Z,K,Ee){W===null&&(W=xn);let Pe=K.isMesh&&K.matrixWorld.determinantAffine()<0,Te=Jo(P,W,j,Z,K);we.setMaterial(Z,Pe);let Ie=j.index,Be=1;if(Z.wireframe===!0){if(Ie=q.getWireframeAttribute(j),Ie===void 0)return;Be=2}let tt=j.drawRange,dt=j.attributes.position,Fe=tt.start*Be,ft=(tt.start+tt.count)*Be;Ee!==null&&(Fe=Math.max(Fe,Ee.start*Be),ft=Math.min(ft,(Ee.start+Ee.count)*Be)),Ie!==null?(Fe=Math.max(Fe,0),ft=Math.min(ft,Ie.count)):dt!=null&&(Fe=Math.max(Fe,0),ft=Math.min(ft,dt.count));let Jt=ft-Fe;if(Jt<0||Jt===1/0)return;be.setup(K,Z,Te,j,Ie);let Rt,Pt=ne;if(Ie!==null&&(Rt=T.get(Ie),Pt=Ae,Pt.setIndex(Rt)),K.isMesh)Z.wireframe===!0?(we.setLineWidth(Z.wireframeLinewidth*un()),Pt.setMode(V.LINES)):Pt.setMode(V.TRIANGLES);else if(K.isLine){let _n=Z.linewidth;_n===void 0&&(_n=1),we.setLineWidth(_n*un()),K.isLineSegments?Pt.setMode(V.LINES):K.isLineLoop?Pt.setMode(V.LINE_LOOP):Pt.setMode(V.LINE_STRIP)}else K.isPoints?Pt.setMode(V.POINTS):K.isSprite&&Pt.setMode(V.TRIANGLES);if(K.isBatchedMesh)if(Ze.get("WEBGL_multi_draw"))Pt.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let _n=K._multiDrawStarts,Oe=K._multiDrawCounts,hn=K._multiDrawCount,gt=Ie?T.get(Ie).bytesPerElement:1,as=ze.get(Z).currentProgram.getUniforms();for(let dn=0;dn<hn;dn++)as.setValue(V,"_gl_DrawID",dn),Pt.render(_n[dn]/gt,Oe[dn])}else if(K.isInstancedMesh)Pt.renderInstances(Fe,Jt,K.count);else if(j.isInstancedBufferGeometry){let _n=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Oe=Math.min(j.instanceCount,_n);Pt.renderInstances(Fe,Jt,Oe)}else Pt.render(Fe,Jt)};function Yo(P,W,j,Z){D!==null&&P.isNodeMaterial&&D.setObject(Z,P),Vt===!0&&re.setState(P,j,!1),P.transparent===!0&&P.side===zn&&P.forceSinglePass===!1?(P.side=Kn,P.needsUpdate=!0,zi(P,W,Z),P.side=Js,P.needsUpdate=!0,zi(P,W,Z),P.side=zn):zi(P,W,Z)}this.compile=function(P,W,j=null){j===null&&(j=P),D!==null&&D.renderStart(P,W,j),A=te.get(j),A.init(W),M.push(A),j.traverseVisible(function(K){K.isLight&&K.layers.test(W.layers)&&(A.pushLight(K),K.castShadow&&A.pushShadow(K))}),P!==j&&P.traverseVisible(function(K){K.isLight&&K.layers.test(W.layers)&&(A.pushLight(K),K.castShadow&&A.pushShadow(K))}),A.setupLights(),D!==null&&D.updateLights(A.state.lightsArray),cn=this.localClippingEnabled,Vt=re.init(this.clippingPlanes,cn),Vt===!0&&re.setGlobalState(this.clippingPlanes,W),D!==null&&me.render(A.state.shadowsArray,j,W);let Z=new Set;return P.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Ee=K.material;if(Ee)if(Array.isArray(Ee))for(let Pe=0;Pe<Ee.length;Pe++){let Te=Ee[Pe];Yo(Te,j,W,K),Z.add(Te)}else Yo(Ee,j,W,K),Z.add(Ee)}),A=M.pop(),D!==null&&D.renderEnd(),Z},this.compileAsync=function(P,W,j=null){let Z=this.compile(P,W,j);return new Promise(K=>{function Ee(){if(Z.forEach(function(Pe){let Ie=ze.get(Pe).currentProgram;(Ie===void 0||Ie.isReady())&&Z.delete(Pe)}),Z.size===0){K(P);return}setTimeout(Ee,10)}Ze.get("KHR_parallel_shader_compile")!==null?Ee():setTimeout(Ee,10)})};let kr=null;function bh(P){kr&&kr(P)}function hl(){rs.stop()}function Bi(){rs.start()}let rs=new Bg;rs.setAnimationLoop(bh),typeof self<"u"&&rs.setContext(self),this.setAnimationLoop=function(P){kr=P,ce.setAnimationLoop(P),P===null?rs.stop():rs.start()},ce.addEventListener("sessionstart",hl),ce.addEventListener("sessionend",Bi),this.render=function(P,W){if(W!==void 0&&W.isCamera!==!0){Qe("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(C===!0)return;D!==null&&D.renderStart(P,W);let j=ce.enabled===!0&&ce.isPresenting===!0,Z=I!==null&&(se===null||j)&&I.begin(L,se);if(P.matrixWorldAutoUpdate===!0&&P.updateMatrixWorld(),W.parent===null&&W.matrixWorldAutoUpdate===!0&&W.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(I===null||I.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(W),W=ce.getCamera()),P.isScene===!0&&P.onBeforeRender(L,P,W,se),A=te.get(P,M.length),A.init(W),A.state.textureUnits=Xe.getTextureUnits(),M.push(A),Nt.multiplyMatrices(W.projectionMatrix,W.matrixWorldInverse),W.isArrayCamera?Zt.setFromArrayCamera(W):nt.setFromProjectionMatrix(Nt,vi,W.reversedDepth),cn=this.localClippingEnabled,Vt=re.init(this.clippingPlanes,cn),E=ye.get(P,y.length),E.init(),y.push(E),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Pe=L.xr.getDepthSensingMesh();Pe!==null&&os(Pe,W,-1/0,L.sortObjects)}os(P,W,0,L.sortObjects),E.finish(),D!==null&&D.updateLights(A.state.lightsArray),L.sortObjects===!0&&E.sort(He,st),jt=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,jt&&z.addToRenderList(E,P),this.info.autoReset===!0&&this.info.reset(),Vt===!0&&re.beginShadows();let K=A.state.shadowsArray;if(me.render(K,P,W),Vt===!0&&re.endShadows(),(Z&&I.hasRenderPass())===!1){let Pe=E.opaque,Te=E.transmissive;if(A.setupLights(),W.isArrayCamera){let Ie=W.cameras;if(Te.length>0)for(let Be=0,tt=Ie.length;Be<tt;Be++){let dt=Ie[Be];wi(Pe,Te,P,dt)}jt&&z.render(P);for(let Be=0,tt=Ie.length;Be<tt;Be++){let dt=Ie[Be];Zo(E,P,dt,dt.viewport)}}else Te.length>0&&wi(Pe,Te,P,W),jt&&z.render(P),Zo(E,P,W)}se!==null&&H===0&&(Xe.updateMultisampleRenderTarget(se),Xe.updateRenderTargetMipmap(se)),Z&&I.end(L),P.isScene===!0&&P.onAfterRender(L,P,W),be.resetDefaultState(),Y=-1,Q=null,M.pop(),M.length>0?(A=M[M.length-1],Xe.setTextureUnits(A.state.textureUnits),Vt===!0&&re.setGlobalState(L.clippingPlanes,A.state.camera)):A=null,y.pop(),y.length>0?E=y[y.length-1]:E=null,D!==null&&D.renderEnd()};function os(P,W,j,Z){if(P.visible===!1)return;if(P.layers.test(W.layers)){if(P.isGroup)j=P.renderOrder;else if(P.isLOD)P.autoUpdate===!0&&P.update(W);else if(P.isLight)A.pushLight(P),P.castShadow&&A.pushShadow(P);else if(P.isSprite){let Pe=W.isArrayCamera?Zt:nt;if(!P.frustumCulled||P.intersectsFrustum(Pe)){Z&&vt.setFromMatrixPosition(P.matrixWorld).applyMatrix4(Nt);let Te=ue.update(P),Ie=P.material;Ie.visible&&E.push(P,Te,Ie,j,vt.z,null,W)}}else if(P.isMesh||P.isLine||P.isPoints){let Pe=W.isArrayCamera?Zt:nt;if(!P.frustumCulled||P.intersectsFrustum(Pe)){let Te=ue.update(P),Ie=P.material;if(Z&&(P.boundingSphere!==void 0?(P.boundingSphere===null&&P.computeBoundingSphere(),vt.copy(P.boundingSphere.center)):(Te.boundingSphere===null&&Te.computeBoundingSphere(),vt.copy(Te.boundingSphere.center)),vt.applyMatrix4(P.matrixWorld).applyMatrix4(Nt)),Array.isArray(Ie)){let Be=Te.groups;for(let tt=0,dt=Be.length;tt<dt;tt++){let Fe=Be[tt],ft=Ie[Fe.materialIndex];ft&&ft.visible&&E.push(P,Te,ft,j,vt.z,Fe,W)}}else Ie.visible&&E.push(P,Te,Ie,j,vt.z,null,W)}}}let Ee=P.children;for(let Pe=0,Te=Ee.length;Pe<Te;Pe++)os(Ee[Pe],W,j,Z)}function Zo(P,W,j,Z){let{opaque:K,transmissive:Ee,transparent:Pe}=P;A.setupLightsView(j),Vt===!0&&re.setGlobalState(L.clippingPlanes,j),Z&&we.viewport(ie.copy(Z)),K.length>0&&Qt(K,W,j),Ee.length>0&&Qt(Ee,W,j),Pe.length>0&&Qt(Pe,W,j),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function wi(P,W,j,Z){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[Z.id]===void 0){let Fe=Ze.has("EXT_color_buffer_half_float")||Ze.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[Z.id]=new hi(1,1,{generateMipmaps:!0,type:Fe?Li:ei,minFilter:Ms,samples:Math.max(4,rt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:xt.workingColorSpace})}let Ee=A.state.transmissionRenderTarget[Z.id],Pe=Z.viewport||ie;Ee.setSize(Pe.z*L.transmissionResolutionScale,Pe.w*L.transmissionResolutionScale);let Te=L.getRenderTarget(),Ie=L.getActiveCubeFace(),Be=L.getActiveMipmapLevel();L.setRenderTarget(Ee),L.getClearColor(ee),he=L.getClearAlpha(),he<1&&L.setClearColor(16777215,.5),L.clear(),jt&&z.render(j);let tt=L.toneMapping;L.toneMapping=es;let dt=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),A.setupLightsView(Z),Vt===!0&&re.setGlobalState(L.clippingPlanes,Z),Qt(P,j,Z),Xe.updateMultisampleRenderTarget(Ee),Xe.updateRenderTargetMipmap(Ee),Ze.has("WEBGL_multisampled_render_to_texture")===!1){let Fe=!1;for(let ft=0,Jt=W.length;ft<Jt;ft++){let Rt=W[ft],{object:Pt,geometry:_n,material:Oe,group:hn}=Rt;if(Oe.side===zn&&Pt.layers.test(Z.layers)){let gt=Oe.side;Oe.side=Kn,Oe.needsUpdate=!0,rn(Pt,j,Z,_n,Oe,hn),Oe.side=gt,Oe.needsUpdate=!0,Fe=!0}}Fe===!0&&(Xe.updateMultisampleRenderTarget(Ee),Xe.updateRenderTargetMipmap(Ee))}L.setRenderTarget(Te,Ie,Be),L.setClearColor(ee,he),dt!==void 0&&(Z.viewport=dt),L.toneMapping=tt}function Qt(P,W,j){let Z=W.isScene===!0?W.overrideMaterial:null;for(let K=0,Ee=P.length;K<Ee;K++){let Pe=P[K],{object:Te,geometry:Ie,group:Be}=Pe,tt=Pe.material;tt.allowOverride===!0&&Z!==null&&(tt=Z),Te.layers.test(j.layers)&&rn(Te,W,j,Ie,tt,Be)}}function rn(P,W,j,Z,K,Ee){D!==null&&K.isNodeMaterial&&D.setObject(P,K),P.onBeforeRender(L,W,j,Z,K,Ee),P.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,P.matrixWorld),P.normalMatrix.getNormalMatrix(P.modelViewMatrix),K.onBeforeRender(L,W,j,Z,P,Ee),K.transparent===!0&&K.side===zn&&K.forceSinglePass===!1?(K.side=Kn,K.needsUpdate=!0,L.renderBufferDirect(j,W,Z,K,P,Ee),K.side=Js,K.needsUpdate=!0,L.renderBufferDirect(j,W,Z,K,P,Ee),K.side=zn):L.renderBufferDirect(j,W,Z,K,P,Ee),P.onAfterRender(L,W,j,Z,K,Ee)}function on(P){let W=0;for(let j of P)j.texture!==null&&W++;return W}function zi(P,W,j){W.isScene!==!0&&(W=xn);let Z=ze.get(P),K=A.state.lights,Ee=A.state.shadowsArray,Pe=K.state.version,Te=ae.getParameters(P,K.state,Ee,W,j,A.state.lightProbeGridArray),Ie=ae.getProgramCacheKey(Te),Be=Z.programs;Z.environment=P.isMeshStandardMaterial||P.isMeshLambertMaterial||P.isMeshPhongMaterial?W.environment:null,Z.fog=W.fog;let tt=P.isMeshStandardMaterial||P.isMeshLambertMaterial&&!P.envMap||P.isMeshPhongMaterial&&!P.envMap;Z.envMap=O.get(P.envMap||Z.environment,tt),Z.envMapRotation=Z.environment!==null&&P.envMap===null?W.environmentRotation:P.envMapRotation,Be===void 0&&(P.addEventListener("dispose",ot),Be=new Map,Z.programs=Be,Z.programVariants=new Map);let dt=Be.get(Ie);if(dt!==void 0){if(Z.currentProgram===dt&&Z.lightsStateVersion===Pe)return Ko(P,Te),dt}else Te.uniforms=ae.getUniforms(P),D!==null&&P.isNodeMaterial&&D.build(P,j,Te),P.onBeforeCompile(Te,L),dt=ae.acquireProgram(Te,Ie),Be.set(Ie,dt),Z.uniforms=Te.uniforms;let Fe=Z.uniforms;return(!P.isShaderMaterial&&!P.isRawShaderMaterial||P.clipping===!0)&&(Fe.clippingPlanes=re.uniform),Ko(P,Te),Z.needsLights=Ls(P),Z.lightsStateVersion=Pe,Z.needsLights&&(Fe.ambientLightColor.value=K.state.ambient,Fe.lightProbe.value=K.state.probe,Fe.sunLights.value=K.state.sun,Fe.sunLightShadows.value=K.state.sunShadow,Fe.directionalLights.value=K.state.directional,Fe.directionalLightShadows.value=K.state.directionalShadow,Fe.spotLights.value=K.state.spot,Fe.spotLightShadows.value=K.state.spotShadow,Fe.rectAreaLights.value=K.state.rectArea,Fe.ltc_1.value=K.state.rectAreaLTC1,Fe.ltc_2.value=K.state.rectAreaLTC2,Fe.pointLights.value=K.state.point,Fe.pointLightShadows.value=K.state.pointShadow,Fe.hemisphereLights.value=K.state.hemi,Fe.sunShadowMatrix.value=K.state.sunShadowMatrix,Fe.sunShadowCascade.value=K.state.sunShadowCascade,Fe.directionalShadowMatrix.value=K.state.directionalShadowMatrix,Fe.spotLightMatrix.value=K.state.spotLightMatrix,Fe.spotLightMap.value=K.state.spotLightMap,Fe.pointShadowMatrix.value=K.state.pointShadowMatrix),Z.numLightProbeGrids=on(A.state.lightProbeGridArray),Z.currentProgram=dt,Z.uniformsList=null,dt}function ni(P,W,j,Z,K){let Ee=ze.get(P),Pe=Ee.currentProgram.id+","+Z+","+K,Te=Ee.programVariants.get(Pe);return Te===void 0?(Te=zi(P,W,j),Ee.programVariants.set(Pe,Te)):(Ee.currentProgram=Te,Ee.uniformsList=null,Ee.outputColorSpace=Z,Ee.toneMapping=K),Te}function Is(P){if(P.uniformsList===null){let W=P.currentProgram.getUniforms();P.uniformsList=Eo.seqWithValue(W.seq,P.uniforms)}return P.uniformsList}function Ko(P,W){let j=ze.get(P);j.outputColorSpace=W.outputColorSpace,j.batching=W.batching,j.batchingColor=W.batchingColor,j.instancing=W.instancing,j.instancingColor=W.instancingColor,j.instancingMorph=W.instancingMorph,j.skinning=W.skinning,j.morphTargets=W.morphTargets,j.morphNormals=W.morphNormals,j.morphColors=W.morphColors,j.morphTargetsCount=W.morphTargetsCount,j.numClippingPlanes=W.numClippingPlanes,j.numIntersection=W.numClipIntersection,j.vertexAlphas=W.vertexAlphas,j.vertexTangents=W.vertexTangents,j.toneMapping=W.toneMapping}function Jo(P,W,j,Z,K){W.isScene!==!0&&(W=xn),Xe.resetTextureUnits();let Ee=W.fog,Pe=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial?W.environment:null,Te=se===null?L.outputColorSpace:se.isXRRenderTarget===!0?se.texture.colorSpace:xt.workingColorSpace,Ie=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial&&!Z.envMap||Z.isMeshPhongMaterial&&!Z.envMap,Be=O.get(Z.envMap||Pe,Ie),tt=Z.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,dt=!!j.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),Fe=!!j.morphAttributes.position,ft=!!j.morphAttributes.normal,Jt=!!j.morphAttributes.color,Rt=es;Z.toneMapped&&(se===null||se.isXRRenderTarget===!0)&&(Rt=L.toneMapping);let Pt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,_n=Pt!==void 0?Pt.length:0,Oe=ze.get(Z),hn=A.state.lights;if(Vt===!0&&(cn===!0||P!==Q)){let It=P===Q&&Z.id===Y;re.setState(Z,P,It)}let gt=!1,as=!1;Z.version===Oe.__version?Oe.needsLights&&Oe.lightsStateVersion!==hn.state.version||K.isBatchedMesh&&Oe.batching===!1||!K.isBatchedMesh&&Oe.batching===!0||K.isBatchedMesh&&Oe.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Oe.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Oe.instancing===!1||!K.isInstancedMesh&&Oe.instancing===!0||K.isSkinnedMesh&&Oe.skinning===!1||!K.isSkinnedMesh&&Oe.skinning===!0||K.isInstancedMesh&&Oe.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Oe.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Oe.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Oe.instancingMorph===!1&&K.morphTexture!==null||Oe.envMap!==Be||Z.fog===!0&&Oe.fog!==Ee||Oe.numClippingPlanes!==void 0&&(Oe.numClippingPlanes!==re.numPlanes||Oe.numIntersection!==re.numIntersection)||Oe.vertexAlphas!==tt||Oe.vertexTangents!==dt||Oe.morphTargets!==Fe||Oe.morphNormals!==ft||Oe.morphColors!==Jt||Oe.morphTargetsCount!==_n||Oe.numLightProbeGrids!==on(A.state.lightProbeGridArray)?gt=!0:(Oe.outputColorSpace!==Te||Oe.toneMapping!==Rt)&&(as=!0):(gt=!0,Oe.__version=Z.version);let dn=Oe.currentProgram;(gt===!0||as===!0)&&(dn=as===!0?ni(Z,W,K,Te,Rt):zi(Z,W,K),D&&Z.isNodeMaterial&&D.onUpdateProgram(Z,dn,Oe));let zr=!1,Vi=!1,ls=!1,ct=dn.getUniforms(),en=Oe.uniforms;if(we.useProgram(dn.program)&&(zr=!0,Vi=!0,ls=!0),Z.id!==Y&&(Y=Z.id,Vi=!0),zr||Q!==P){we.buffers.depth.getReversed()&&P.reversedDepth!==!0&&(P._reversedDepth=!0,P.updateProjectionMatrix()),ct.setValue(V,"projectionMatrix",P.projectionMatrix),ct.setValue(V,"viewMatrix",P.matrixWorldInverse);let fn=ct.map.cameraPosition;fn!==void 0&&fn.setValue(V,An.setFromMatrixPosition(P.matrixWorld)),rt.logarithmicDepthBuffer&&ct.setValue(V,"logDepthBufFC",2/(Math.log(P.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&ct.setValue(V,"isOrthographic",P.isOrthographicCamera===!0),Q!==P&&(Q=P,Vi=!0,ls=!0)}if(Oe.needsLights&&(hn.state.sunShadowMap.length>0&&ct.setValue(V,"sunShadowMap",hn.state.sunShadowMap,Xe),hn.state.directionalShadowMap.length>0&&ct.setValue(V,"directionalShadowMap",hn.state.directionalShadowMap,Xe),hn.state.spotShadowMap.length>0&&ct.setValue(V,"spotShadowMap",hn.state.spotShadowMap,Xe),hn.state.pointShadowMap.length>0&&ct.setValue(V,"pointShadowMap",hn.state.pointShadowMap,Xe)),K.isSkinnedMesh){ct.setOptional(V,K,"bindMatrix"),ct.setOptional(V,K,"bindMatrixInverse");let It=K.skeleton;It&&(It.boneTexture===null&&It.computeBoneTexture(),ct.setValue(V,"boneTexture",It.boneTexture,Xe))}K.isBatchedMesh&&(ct.setOptional(V,K,"batchingTexture"),ct.setValue(V,"batchingTexture",K._matricesTexture,Xe),ct.setOptional(V,K,"batchingIdTexture"),ct.setValue(V,"batchingIdTexture",K._indirectTexture,Xe),ct.setOptional(V,K,"batchingColorTexture"),K._colorsTexture!==null&&ct.setValue(V,"batchingColorTexture",K._colorsTexture,Xe));let Hn=j.morphAttributes;if((Hn.position!==void 0||Hn.normal!==void 0||Hn.color!==void 0)&&oe.update(K,j,dn),(Vi||Oe.receiveShadow!==K.receiveShadow)&&(Oe.receiveShadow=K.receiveShadow,ct.setValue(V,"receiveShadow",K.receiveShadow)),(Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial)&&Z.envMap===null&&W.environment!==null&&(en.envMapIntensity.value=W.environmentIntensity),en.dfgLUT!==void 0&&(en.dfgLUT.value=gA()),Vi){if(ct.setValue(V,"toneMappingExposure",L.toneMappingExposure),Oe.needsLights&&Fr(en,ls),Ee&&Z.fog===!0&&_e.refreshFogUniforms(en,Ee),_e.refreshMaterialUniforms(en,Z,Me,Se,A.state.transmissionRenderTarget[P.id]),Oe.needsLights&&Oe.numLightProbeGrids>0){let It=v,fn=0;for(let Un of A.state.lightProbeGridArray)Un.texture!==null&&(It.textures[fn]=Un.texture,It.min[fn]=Un.boundingBox.min,It.max[fn]=Un.boundingBox.max,It.resolution[fn]=Un.resolution,fn++);for(let Un in It)It[Un].length=fn;en.probesSH.value=It.textures,en.probesMin.value=It.min,en.probesMax.value=It.max,en.probesResolution.value=It.resolution}Eo.upload(V,Is(Oe),en,Xe)}if(Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(Eo.upload(V,Is(Oe),en,Xe),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&ct.setValue(V,"center",K.center),ct.setValue(V,"modelViewMatrix",K.modelViewMatrix),ct.setValue(V,"normalMatrix",K.normalMatrix),ct.setValue(V,"modelMatrix",K.matrixWorld),Z.uniformsGroups!==void 0){let It=Z.uniformsGroups;for(let fn=0,Un=It.length;fn<Un;fn++){let dl=It[fn];Ge.update(dl,dn),Ge.bind(dl,dn)}}return dn}function Fr(P,W){P.ambientLightColor.needsUpdate=W,P.lightProbe.needsUpdate=W,P.sunLights.needsUpdate=W,P.sunLightShadows.needsUpdate=W,P.directionalLights.needsUpdate=W,P.directionalLightShadows.needsUpdate=W,P.pointLights.needsUpdate=W,P.pointLightShadows.needsUpdate=W,P.spotLights.needsUpdate=W,P.spotLightShadows.needsUpdate=W,P.rectAreaLights.needsUpdate=W,P.hemisphereLights.needsUpdate=W}function Ls(P){return P.isMeshLambertMaterial||P.isMeshToonMaterial||P.isMeshPhongMaterial||P.isMeshStandardMaterial||P.isShadowMaterial||P.isShaderMaterial&&P.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return se},this.setRenderTargetTextures=function(P,W,j){let Z=ze.get(P);Z.__autoAllocateDepthBuffer=P.resolveDepthBuffer===!1,Z.__autoAllocateDepthBuffer===!1&&(Z.__useRenderToTexture=!1),ze.get(P.texture).__webglTexture=W,ze.get(P.depthTexture).__webglTexture=Z.__autoAllocateDepthBuffer?void 0:j,Z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(P,W){let j=ze.get(P);j.__webglFramebuffer=W,j.__useDefaultFramebuffer=W===void 0},this.setRenderTarget=function(P,W=0,j=0){se=P,$=W,H=j;let Z=null,K=!1,Ee=!1;if(P){let Te=ze.get(P);if(Te.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(V.FRAMEBUFFER,Te.__webglFramebuffer),ie.copy(P.viewport),fe.copy(P.scissor),de=P.scissorTest,we.viewport(ie),we.scissor(fe),we.setScissorTest(de),Y=-1;return}else if(Te.__webglFramebuffer===void 0)Xe.setupRenderTarget(P);else if(Te.__hasExternalTextures)Xe.rebindTextures(P,ze.get(P.texture).__webglTexture,ze.get(P.depthTexture).__webglTexture);else if(P.depthBuffer){let tt=P.depthTexture;if(Te.__boundDepthTexture!==tt){if(tt!==null&&ze.has(tt)&&(P.width!==tt.image.width||P.height!==tt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Xe.setupDepthRenderbuffer(P)}}let Ie=P.texture;(Ie.isData3DTexture||Ie.isDataArrayTexture||Ie.isCompressedArrayTexture)&&(Ee=!0);let Be=ze.get(P).__webglFramebuffer;P.isWebGLCubeRenderTarget?(Array.isArray(Be[W])?Z=Be[W][j]:Z=Be[W],K=!0):P.samples>0&&Xe.useMultisampledRTT(P)===!1?Z=ze.get(P).__webglMultisampledFramebuffer:Array.isArray(Be)?Z=Be[j]:Z=Be,ie.copy(P.viewport),fe.copy(P.scissor),de=P.scissorTest}else ie.copy(Ve).multiplyScalar(Me).floor(),fe.copy(ht).multiplyScalar(Me).floor(),de=lt;if(j!==0&&(Z=k),we.bindFramebuffer(V.FRAMEBUFFER,Z)&&we.drawBuffers(P,Z),we.viewport(ie),we.scissor(fe),we.setScissorTest(de),K){let Te=ze.get(P.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_CUBE_MAP_POSITIVE_X+W,Te.__webglTexture,j)}else if(Ee){let Te=W;for(let Ie=0;Ie<P.textures.length;Ie++){let Be=ze.get(P.textures[Ie]);V.framebufferTextureLayer(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0+Ie,Be.__webglTexture,j,Te)}}else if(P!==null&&j!==0){let Te=ze.get(P.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,Te.__webglTexture,j)}Y=-1};function Br(P){let W=ze.get(P);return(W.__readFormat!==P.format||W.__readType!==P.type)&&(W.__readFormat=P.format,W.__readType=P.type,W.__formatReadable=rt.textureFormatReadable(P.format),W.__typeReadable=rt.textureTypeReadable(P.type)),W}this.readRenderTargetPixels=function(P,W,j,Z,K,Ee,Pe,Te=0){if(!(P&&P.isWebGLRenderTarget)){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ie=ze.get(P).__webglFramebuffer;if(P.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie){we.bindFramebuffer(V.FRAMEBUFFER,Ie);try{let Be=P.textures[Te],tt=Be.format,dt=Be.type;P.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+Te);let Fe=Br(Be);if(Fe.__formatReadable===!1){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Fe.__typeReadable===!1){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}W>=0&&W<=P.width-Z&&j>=0&&j<=P.height-K&&V.readPixels(W,j,Z,K,xe.convert(tt),xe.convert(dt),Ee)}finally{let Be=se!==null?ze.get(se).__webglFramebuffer:null;we.bindFramebuffer(V.FRAMEBUFFER,Be)}}},this.readRenderTargetPixelsAsync=async function(P,W,j,Z,K,Ee,Pe,Te=0){if(!(P&&P.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ie=ze.get(P).__webglFramebuffer;if(P.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie)if(W>=0&&W<=P.width-Z&&j>=0&&j<=P.height-K){we.bindFramebuffer(V.FRAMEBUFFER,Ie);let Be=P.textures[Te],tt=Be.format,dt=Be.type;P.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+Te);let Fe=Br(Be);if(Fe.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Fe.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ft=V.createBuffer();V.bindBuffer(V.PIXEL_PACK_BUFFER,ft),V.bufferData(V.PIXEL_PACK_BUFFER,Ee.byteLength,V.STREAM_READ),V.readPixels(W,j,Z,K,xe.convert(tt),xe.convert(dt),0),V.bindBuffer(V.PIXEL_PACK_BUFFER,null);let Jt=se!==null?ze.get(se).__webglFramebuffer:null;we.bindFramebuffer(V.FRAMEBUFFER,Jt);let Rt=V.fenceSync(V.SYNC_GPU_COMMANDS_COMPLETE,0);return V.flush(),await ug(V,Rt,4),V.bindBuffer(V.PIXEL_PACK_BUFFER,ft),V.getBufferSubData(V.PIXEL_PACK_BUFFER,0,Ee),V.bindBuffer(V.PIXEL_PACK_BUFFER,null),V.deleteBuffer(ft),V.deleteSync(Rt),Ee}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(P,W=null,j=0){let Z=Math.pow(2,-j),K=Math.floor(P.image.width*Z),Ee=Math.floor(P.image.height*Z),Pe=W!==null?W.x:0,Te=W!==null?W.y:0;Xe.setTexture2D(P,0),V.copyTexSubImage2D(V.TEXTURE_2D,j,0,0,Pe,Te,K,Ee),we.unbindTexture()},this.copyTextureToTexture=function(P,W,j=null,Z=null,K=0,Ee=0){let Pe,Te,Ie,Be,tt,dt,Fe,ft,Jt,Rt=P.isCompressedTexture?P.mipmaps[Ee]:P.image;if(j!==null)Pe=j.max.x-j.min.x,Te=j.max.y-j.min.y,Ie=j.isBox3?j.max.z-j.min.z:1,Be=j.min.x,tt=j.min.y,dt=j.isBox3?j.min.z:0;else{let ct=Math.pow(2,-K);Pe=Math.floor(Rt.width*ct),Te=Math.floor(Rt.height*ct),P.isDataArrayTexture?Ie=Rt.depth:P.isData3DTexture?Ie=Math.floor(Rt.depth*ct):Ie=1,Be=0,tt=0,dt=0}Z!==null?(Fe=Z.x,ft=Z.y,Jt=Z.z):(Fe=0,ft=0,Jt=0);let Pt=xe.convert(W.format),_n=xe.convert(W.type),Oe;W.isData3DTexture?(Xe.setTexture3D(W,0),Oe=V.TEXTURE_3D):W.isDataArrayTexture||W.isCompressedArrayTexture?(Xe.setTexture2DArray(W,0),Oe=V.TEXTURE_2D_ARRAY):(Xe.setTexture2D(W,0),Oe=V.TEXTURE_2D),we.activeTexture(V.TEXTURE0),we.pixelStorei(V.UNPACK_FLIP_Y_WEBGL,W.flipY),we.pixelStorei(V.UNPACK_PREMULTIPLY_ALPHA_WEBGL,W.premultiplyAlpha),we.pixelStorei(V.UNPACK_ALIGNMENT,W.unpackAlignment);let hn=we.getParameter(V.UNPACK_ROW_LENGTH),gt=we.getParameter(V.UNPACK_IMAGE_HEIGHT),as=we.getParameter(V.UNPACK_SKIP_PIXELS),dn=we.getParameter(V.UNPACK_SKIP_ROWS),zr=we.getParameter(V.UNPACK_SKIP_IMAGES);we.pixelStorei(V.UNPACK_ROW_LENGTH,Rt.width),we.pixelStorei(V.UNPACK_IMAGE_HEIGHT,Rt.height),we.pixelStorei(V.UNPACK_SKIP_PIXELS,Be),we.pixelStorei(V.UNPACK_SKIP_ROWS,tt),we.pixelStorei(V.UNPACK_SKIP_IMAGES,dt);let Vi=P.isDataArrayTexture||P.isData3DTexture,ls=W.isDataArrayTexture||W.isData3DTexture;if(P.isDepthTexture){let ct=ze.get(P),en=ze.get(W),Hn=ze.get(ct.__renderTarget),It=ze.get(en.__renderTarget);we.bindFramebuffer(V.READ_FRAMEBUFFER,Hn.__webglFramebuffer),we.bindFramebuffer(V.DRAW_FRAMEBUFFER,It.__webglFramebuffer);for(let fn=0;fn<Ie;fn++)Vi&&(V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,ze.get(P).__webglTexture,K,dt+fn),V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,ze.get(W).__webglTexture,Ee,Jt+fn)),V.blitFramebuffer(Be,tt,Be+Pe,tt+Te,Fe,ft,Fe+Pe,ft+Te,V.DEPTH_BUFFER_BIT,V.NEAREST);we.bindFramebuffer(V.READ_FRAMEBUFFER,null),we.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else if(K!==0||P.isRenderTargetTexture||ze.has(P)){let ct=ze.get(P),en=ze.get(W);we.bindFramebuffer(V.READ_FRAMEBUFFER,N),we.bindFramebuffer(V.DRAW_FRAMEBUFFER,B);for(let Hn=0;Hn<Ie;Hn++)Vi?V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,ct.__webglTexture,K,dt+Hn):V.framebufferTexture2D(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,ct.__webglTexture,K),ls?V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,en.__webglTexture,Ee,Jt+Hn):V.framebufferTexture2D(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,en.__webglTexture,Ee),K!==0?V.blitFramebuffer(Be,tt,Be+Pe,tt+Te,Fe,ft,Fe+Pe,ft+Te,V.COLOR_BUFFER_BIT,V.NEAREST):ls?V.copyTexSubImage3D(Oe,Ee,Fe,ft,Jt+Hn,Be,tt,Pe,Te):V.copyTexSubImage2D(Oe,Ee,Fe,ft,Be,tt,Pe,Te);we.bindFramebuffer(V.READ_FRAMEBUFFER,null),we.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else ls?P.isDataTexture||P.isData3DTexture?V.texSubImage3D(Oe,Ee,Fe,ft,Jt,Pe,Te,Ie,Pt,_n,Rt.data):W.isCompressedArrayTexture?V.compressedTexSubImage3D(Oe,Ee,Fe,ft,Jt,Pe,Te,Ie,Pt,Rt.data):V.texSubImage3D(Oe,Ee,Fe,ft,Jt,Pe,Te,Ie,Pt,_n,Rt):P.isDataTexture?V.texSubImage2D(V.TEXTURE_2D,Ee,Fe,ft,Pe,Te,Pt,_n,Rt.data):P.isCompressedTexture?V.compressedTexSubImage2D(V.TEXTURE_2D,Ee,Fe,ft,Rt.width,Rt.height,Pt,Rt.data):V.texSubImage2D(V.TEXTURE_2D,Ee,Fe,ft,Pe,Te,Pt,_n,Rt);we.pixelStorei(V.UNPACK_ROW_LENGTH,hn),we.pixelStorei(V.UNPACK_IMAGE_HEIGHT,gt),we.pixelStorei(V.UNPACK_SKIP_PIXELS,as),we.pixelStorei(V.UNPACK_SKIP_ROWS,dn),we.pixelStorei(V.UNPACK_SKIP_IMAGES,zr),Ee===0&&W.generateMipmaps===!0&&W.mipmapsAutoUpdate===!0&&V.generateMipmap(Oe),we.unbindTexture()},this.initRenderTarget=function(P){ze.get(P).__webglFramebuffer===void 0&&Xe.setupRenderTarget(P)},this.initTexture=function(P){P.isCubeTexture?Xe.setTextureCube(P,0):P.isData3DTexture?Xe.setTexture3D(P,0):P.isDataArrayTexture||P.isCompressedArrayTexture?Xe.setTexture2DArray(P,0):Xe.setTexture2D(P,0),we.unbindTexture()},this.resetState=function(){$=0,H=0,se=null,we.reset(),be.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return vi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=xt._getDrawingBufferColorSpace(e),t.unpackColorSpace=xt._getUnpackColorSpace()}};function Cr(n){let e=new Ss;return e.userData.nearer=n,n===0||(e.onBeforeCompile=t=>{t.vertexShader=t.vertexShader.replace("#include <project_vertex>",`#include <project_vertex>
      vec4 pulled = vec4(mvPosition.xyz - normalize(mvPosition.xyz) * ${n.toExponential()}, 1.0);
      vec4 nearPosition = projectionMatrix * pulled;
      gl_Position.z = nearPosition.z / nearPosition.w * gl_Position.w;`)},e.customProgramCacheKey=()=>`nearer ${n}`),e}function Co(n,e,t,i,s,r){let o=n[t]-n[e],a=n[t+1]-n[e+1],l=n[t+2]-n[e+2],c=Math.hypot(o,a,l)||1e-12;o/=c,a/=c,l/=c;let u=Math.abs(l)<.9,[h,d,f]=u?[a,-o,0]:[0,l,-a],p=Math.hypot(h,d,f);h/=p,d/=p,f/=p,s[r]=i*h,s[r+1]=i*d,s[r+2]=i*f,s[r+4]=c*o,s[r+5]=c*a,s[r+6]=c*l,s[r+8]=i*(d*l-f*a),s[r+9]=i*(f*o-h*l),s[r+10]=i*(h*a-d*o);for(let x=0;x<3;x++)s[r+12+x]=(n[e+x]+n[t+x])/2;s[r+15]=1}var pu="#d55e00",mu="#0072b2",Kg=["#e2cf9f","#c5bcd9","#b7cfa2","#d6aeb9","#9cc4dd","#cfcfcf"],Jg=["#735826","#54458a","#35693a","#8c4467","#0b5a8a","#525252"];function Qg(n){return Jg[n%Jg.length]}function Ya(n){return Kg[n%Kg.length]}var xA=["#453781","#39568c","#2d708e","#20908d","#29af7f","#73d055","#b8de29","#fde725"],_A=["#00224e","#083370","#35456c","#4f576c","#666970","#7d7c78","#948e77","#aea371","#c8b866","#e5cf52","#fee838"],yA=["#ffffcc","#ffeda0","#fed976","#feb24c","#fd8c3c","#fc4d2a","#e2191c","#bb0026","#800026"];function tf(n){let e=n.map(i=>[1,3,5].map(s=>parseInt(i.slice(s,s+2),16)/255));function t(i,s=[0,0,0]){let r=Math.min(1,Math.max(0,i))*(n.length-1),o=Math.min(n.length-2,Math.floor(r));for(let a=0;a<3;a++){let l=e[o][a];s[a]=l+(r-o)*(e[o+1][a]-l)}return s}return{at:t,gradient:`linear-gradient(to right, ${n.join(", ")})`}}var Ro=tf(xA),e0=tf(_A),gu=tf(yA),ef=null;function _t(n){return getComputedStyle(ef??document.documentElement).getPropertyValue(n).trim()}function nf(){let n=document.createElement("div");return n.className="paper",document.body.append(n),ef=n,()=>{ef=null,n.remove()}}function t0(n){let e=nf();try{return n()}finally{e()}}function Qs(n){let e=matchMedia("(prefers-color-scheme: dark)");return e.addEventListener("change",n),()=>e.removeEventListener("change",n)}var jg=[[],[8,4],[8,3,2,3],[2,3]],vA=7;function Di(n){return{colour:_t(`--line-${n%vA}`),dash:jg[n%jg.length]}}var bA=32767,er=24,SA=5/3*Math.PI,MA=.22,sf=.11,n0=.7,i0=3,s0=1e-6;function r0(n){let e=n.turns.map(l=>({...l,pivot:qt(l.pivot,Float32Array),axis:Float32Array.from(qt(l.axis,Int16Array),c=>c/bA),left:l.left&&qt(l.left,Float32Array)})),t=n.pushes.map(l=>({...l,force:l.force&&qt(l.force,Float32Array)})),{drives:i,stages:s}=n;function r(l){let c=s.find(({start:u,end:h})=>l>u&&l<=h);return i.map(({strength:u,rise:h},d)=>c?.drives.includes(d)?u*(h>0?Math.min(1,(l-c.start)/h):1):0)}let o=(l,c)=>l.reduce((u,h,d)=>u+h*c[d],0),a=l=>l.reduce((c,{shares:u})=>{let h=s.map(d=>Math.abs(o(u,i.map(({strength:f},p)=>d.drives.includes(p)?f:0))));return Math.max(c,...h)},0);return{...n,time:qt(n.time,Float64Array),turns:e,pushes:t,strengthsAt:r,summed:o,largestTurn:a(e),largestPush:a(t)}}function o0({drives:n,strengthsAt:e},t,i){let s=e(t);return n.flatMap(({text:r,unit:o,factor:a},l)=>s[l]?[`${r}: ${i(a*s[l])} ${o}`]:[])}function a0(n){let{time:e,turns:t,pushes:i,strengthsAt:s,summed:r,largestTurn:o,largestPush:a}=n.efforts,l=Math.max(0,...t.map(I=>I.radius)),c=.05*n.mesh.span_m,u=Cr(Math.max(l,c)),h=new di(new ji(1,1,1,10),u,t.length*er+i.length),d=new di(new Ea(1,1,16),u,t.length+i.length),f=new Bn;for(let I of[h,d])I.frustumCulled=!1,f.add(I);let p=new Float32Array(3*(er+2)),[x,g]=[0,0],m=(I,L,C,D,k)=>Co(p,3*L,3*C,D,I.instanceMatrix.array,16*k);function _(I,L){for(let C=0;C<3;C++)p[3*I+C]=L[C]}function b(I,L,C,D){let[k,N]=Rr(e,C),$=(I.left?rf(I.left,1,k,N)[0]:1)*r(I.shares,D)/o;if(!(Math.abs($)>s0))return;let[H,se]=I.ends?wA(L,I.ends):[I.pivot,I.axis].map(he=>rf(he,3,k,N)),Y=EA(se,I),Q=AA(se,Y),ie=SA*Math.min(1.2,Math.abs($))*Math.sign($),fe=he=>H.map((ge,Se)=>ge+I.radius*(Math.cos(he)*Y[Se]+Math.sin(he)*Q[Se]));for(let he=0;he<=er;he++)_(he,fe(ie*(he/er-.5)));let de=ie/2;_(er+1,fe(de+Math.sign($)*n0));let ee=sf*I.radius;for(let he=0;he<er;he++)m(h,he,he+1,ee,x++);m(d,er,er+1,i0*ee,g++)}function v(I,L,C,D){let[k,N]=Rr(e,C),B=I.force?rf(I.force,1,k,N)[0]:r(I.shares,D)/a;if(!(Math.abs(B)>s0))return;let $=MA*n.mesh.span_m*B,H=L.subarray(3*I.point,3*I.point+3),se=Y=>I.direction.map((Q,ie)=>H[ie]+Y*Q);_(0,H),_(1,se($)),_(2,se($+Math.sign(B)*n0*c)),m(h,0,1,sf*c,x++),m(d,1,2,i0*sf*c,g++)}function E(I){[x,g]=[0,0];let L=s(I),C=n.pointsAt(I);for(let D of t)b(D,C,I,L);for(let D of i)v(D,C,I,L);[h.count,d.count]=[x,g];for(let D of[h,d])D.instanceMatrix.needsUpdate=!0}let A=()=>u.color.set(new $e(_t("--effort")));function y(){for(let I of[h,d])I.dispose(),I.geometry.dispose();u.dispose()}return{group:f,pose:E,paint:A,count:()=>g,dispose:y}}function rf(n,e,t,i){if(n.length===e)return Array.from(n);let s=Math.min(t+1,n.length/e-1);return Array.from({length:e},(r,o)=>{let a=n[t*e+o];return a+i*(n[s*e+o]-a)})}function wA(n,[e,t]){let[i,s]=[e,t].map(a=>Array.from(n.subarray(3*a,3*a+3))),r=i.map((a,l)=>s[l]-a),o=Math.hypot(...r)||1;return[i.map((a,l)=>(a+s[l])/2),r.map(a=>a/o)]}function AA(n,e){return[0,1,2].map(t=>n[(t+1)%3]*e[(t+2)%3]-n[(t+2)%3]*e[(t+1)%3])}function EA(n,e){e.side??=n.map(Math.abs).reduce((r,o,a,l)=>o<l[r]-.001?a:r,2);let t=n[e.side],i=n.map((r,o)=>(o===e.side?1:0)-t*r),s=Math.hypot(...i)||1;return i.map(r=>r/s)}var Es="tendon energy",af=Symbol("readings of single creases");function qt(n,e){let t=atob(n),i=new Uint8Array(t.length);for(let s=0;s<t.length;s++)i[s]=t.charCodeAt(s);return new e(i.buffer)}function l0({low:n,step:e,steps:t}){return Float32Array.from(qt(t,Uint16Array),(i,s)=>n[s%n.length]+e[s%n.length]*i)}function Jn(n){let e=qt(n.time,Float64Array),t=typeof n.points=="string"?qt(n.points,Float32Array):l0(n.points),i=3*n.pointCount,s={[Es]:{width:n.tendonParts.length,values:qt(n.tendonEnergy_J,Float32Array)}};for(let _ of n.readings)s[_.name]={width:_.parts.length,values:qt(_.values,Float32Array)};let{creases:r=null}=n,o=(n.along??[]).map(_=>({..._,key:Symbol(_.name)}));for(let{key:_,values:b}of o)s[_]={width:1,values:qt(b,Float32Array)};r&&(s[af]={width:r.values.low.length,values:l0(r.values)});let a=Int32Array.from(n.between),l=Float64Array.from(n.share),c=new Float32Array(i);function u(_,b=c){return of(e,t,i,_,b),b}function h(_,b=new Float32Array(3*l.length)){return d(u(_),b)}function d(_,b){for(let v=0;v<l.length;v++){let E=3*a[2*v],A=3*a[2*v+1];for(let y=0;y<3;y++){let M=_[E+y];b[3*v+y]=M+l[v]*(_[A+y]-M)}}return b}function f(_,b,v=new Float32Array(s[_].width)){return of(e,s[_].values,s[_].width,b,v),v}function p(_,b){let{width:v,values:E}=s[_];return Float32Array.from(e,(A,y)=>E[y*v+b])}let x=qt(n.restLength_m,Float32Array);function g(_,b){x.length===b.length?b.set(x):of(e,x,b.length,_,b)}let m=n.efforts&&r0(n.efforts);return{name:n.name,reach:Math.max(n.base.radius,m?.pushes.length?.12*n.span_m:0,...(m?.turns??[]).map(_=>.4*_.radius)),mesh:n,marks:n.marks,stages:n.stages,tendons:n.tendonParts.length,readings:n.readings,along:o,creases:r,time:e,start:e[0],end:e[e.length-1],efforts:m,strained:n.built!==null,stressed:!!n.membraneLaw,builtVertices:()=>d(qt(n.built,Float32Array),new Float32Array(3*l.length)),restLengthsAt:g,pointsAt:u,verticesAt:h,verticesOf:d,valuesAt:f,line:p,stageAt:_=>n.stages.findLast(b=>b.start<=_)??n.stages[0],markAt:_=>n.marks.find(b=>Math.abs(b.time-_)<1e-9)}}function of(n,e,t,i,s){let[r,o]=Rr(n,i),a=r*t,l=Math.min(r+1,n.length-1)*t;for(let c=0;c<t;c++){let u=e[a+c];s[c]=o===0?u:u+o*(e[l+c]-u)}}function Rr(n,e){if(!(e>n[0]))return[0,0];let t=n.length-1;if(e>=n[t])return[t,0];let i=0,s=t;for(;s-i>1;){let r=i+s>>1;n[r]<=e?i=r:s=r}return[i,(e-n[i])/(n[i+1]-n[i])]}function tr(n,e,t){let[i,s]=Rr(n,t);return s===0?e[i]:e[i]+s*(e[i+1]-e[i])}function xu(){return document.getElementById("engine-program")!==null}async function Po(n,e){let t=new Blob([qt(document.getElementById("engine-script").textContent,Uint8Array)]).stream(),i=await new Response(t.pipeThrough(new DecompressionStream("deflate"))).text(),s=URL.createObjectURL(new Blob([i],{type:"text/javascript"})),r=new Worker(s),o=new Map,a=0;r.onmessage=({data:u})=>{let h=o.get(u.to);h?(o.delete(u.to),u.said==="refused"?h.refuse(new Error(u.why)):h.take(u)):e(u)},r.onerror=u=>{u.preventDefault();let h=new Error(u.message||"the engine stopped");for(let{refuse:d}of o.values())d(h);o.clear(),e({said:"refused",why:h.message})};function l(u){let h=++a;return new Promise((d,f)=>{o.set(h,{take:d,refuse:f}),r.postMessage({...u,number:h})})}function c(){r.terminate(),URL.revokeObjectURL(s)}try{let u=document.getElementById("engine-program").textContent,{frame:h,version:d}=await l({act:"load",program:u,text:n}),f={first:h,version:d,ask:l,send:x=>r.postMessage(x),take:p,end:c};return f;async function p(x,g){let{frame:m}=await l({act:"load",text:x});return e=g,{...f,first:m}}}catch(u){throw c(),u}}var c0={type:"change"},cf={type:"start"},h0={type:"end"},_u=new Hs,u0=new ci,TA=Math.cos(70*Bd.DEG2RAD),Sn=new G,ti=2*Math.PI,At={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},lf=1e-6,yu=class extends Da{constructor(e,t=null){super(e,t),this.state=At.NONE,this.target=new G,this.cursor=new G,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Zs.ROTATE,MIDDLE:Zs.DOLLY,RIGHT:Zs.PAN},this.touches={ONE:Ks.ROTATE,TWO:Ks.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new G,this._lastQuaternion=new ui,this._lastTargetPosition=new G,this._quat=new ui().setFromUnitVectors(e.up,new G(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new vo,this._sphericalDelta=new vo,this._scale=1,this._panOffset=new G,this._rotateStart=new Ye,this._rotateEnd=new Ye,this._rotateDelta=new Ye,this._panStart=new Ye,this._panEnd=new Ye,this._panDelta=new Ye,this._dollyStart=new Ye,this._dollyEnd=new Ye,this._dollyDelta=new Ye,this._dollyDirection=new G,this._mouse=new Ye,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=RA.bind(this),this._onPointerDown=CA.bind(this),this._onPointerUp=PA.bind(this),this._onContextMenu=kA.bind(this),this._onMouseWheel=NA.bind(this),this._onKeyDown=DA.bind(this),this._onTouchStart=OA.bind(this),this._onTouchMove=UA.bind(this),this._onMouseDown=IA.bind(this),this._onMouseMove=LA.bind(this),this._interceptControlDown=FA.bind(this),this._interceptControlUp=BA.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=At.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(c0),this.update(),this.state=At.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Sn.copy(t).sub(this.target),Sn.applyQuaternion(this._quat),this._spherical.setFromVector3(Sn),this.autoRotate&&this.state===At.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ti:i>Math.PI&&(i-=ti),s<-Math.PI?s+=ti:s>Math.PI&&(s-=ti),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Sn.setFromSpherical(this._spherical),Sn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Sn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Sn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new G(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new G(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Sn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(_u.origin.copy(this.object.position),_u.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(_u.direction))<TA?this.object.lookAt(this.target):(u0.setFromNormalAndCoplanarPoint(this.object.up,this.target),_u.intersectPlane(u0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>lf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>lf||this._lastTargetPosition.distanceToSquared(this.target)>lf?(this.dispatchEvent(c0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?ti/60*this.autoRotateSpeed*e:ti/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Sn.setFromMatrixColumn(t,0),Sn.multiplyScalar(-e),this._panOffset.add(Sn)}_panUp(e,t){this.screenSpacePanning===!0?Sn.setFromMatrixColumn(t,1):(Sn.setFromMatrixColumn(t,0),Sn.crossVectors(this.object.up,Sn)),Sn.multiplyScalar(e),this._panOffset.add(Sn)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Sn.copy(s).sub(this.target);let r=Sn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ti*this._rotateDelta.x/t.clientHeight),this._rotateUp(ti*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(ti*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-ti*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(ti*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-ti*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ti*this._rotateDelta.x/t.clientHeight),this._rotateUp(ti*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Ye,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function CA(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function RA(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function PA(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(h0),this.state=At.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function IA(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Zs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=At.DOLLY;break;case Zs.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=At.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=At.ROTATE}break;case Zs.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=At.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=At.PAN}break;default:this.state=At.NONE}this.state!==At.NONE&&this.dispatchEvent(cf)}function LA(n){switch(this.state){case At.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case At.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case At.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function NA(n){this.enabled===!1||this.enableZoom===!1||this.state!==At.NONE||(n.preventDefault(),this.dispatchEvent(cf),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(h0))}function DA(n){this.enabled!==!1&&this._handleKeyDown(n)}function OA(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Ks.ROTATE:if(this.enableRotate===!1){this.state=At.NONE;break}this._handleTouchStartRotate(n),this.state=At.TOUCH_ROTATE;break;case Ks.PAN:if(this.enablePan===!1){this.state=At.NONE;break}this._handleTouchStartPan(n),this.state=At.TOUCH_PAN;break;default:this.state=At.NONE}break;case 2:switch(this.touches.TWO){case Ks.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=At.TOUCH_DOLLY_PAN;break;case Ks.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=At.TOUCH_DOLLY_ROTATE;break;default:this.state=At.NONE}break;default:this.state=At.NONE}this.state!==At.NONE&&this.dispatchEvent(cf)}function UA(n){switch(this._trackPointer(n),this.state){case At.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case At.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case At.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case At.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=At.NONE}}function kA(n){this.enabled!==!1&&n.preventDefault()}function FA(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function BA(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var uf=120,d0=2,f0=6;function hf(n,e,t){let i=new WeakMap,s=e.reduce((l,c)=>n[c].mesh.tubes.reduce((u,h)=>Math.max(u,h.radius),Math.max(l,n[c].reach)),Math.max(...e.map(l=>n[l].mesh.joints.length?n[l].mesh.jointRadius:0))),r=null;function o(){let{span:l}=t;if(!i.has(l)){let c=Array.from({length:uf+1},(u,h)=>t.timeAt(h/uf));i.set(l,c.map(u=>e.map(h=>n[h].pointsAt(t.clipTime(h,u)).slice())))}return i.get(l)}function a(l,c){let u=[...l.flatMap(d=>d.toArray()),...c].join();if(r?.key===u&&r.span===t.span)return r;let h=o().map(d=>zA(d,l,c,s));return r={key:u,span:t.span,rows:VA(h),whole:p0(h)},r}return function(c,u,h,d){let f=new G().crossVectors(u,c).normalize(),p=[f,new G().crossVectors(c,f),c],{rows:x,whole:g}=a(p,h),m=d?GA(x,t.wayAt(t.time)*uf):g,[_,b,v,E,A,y]=m,M=[(_-b)/2,(v-E)/2,(A-y)/2],I=Math.max((_+b)/(2*h[0]),(v+E)/(2*h[1])),L=new G;for(let[C,D]of p.entries())L.addScaledVector(D,M[C]);return{target:L,distance:I-M[2]||1}}}function zA(n,e,t,i){let s=new Float64Array(f0).fill(-1/0),r=t.map(h=>i*Math.hypot(1,h)),o=[r[0],r[0],r[1],r[1],0,0],[a,l,c]=e.map(h=>h.toArray()),u=(h,d,f)=>h[0]*d[f]+h[1]*d[f+1]+h[2]*d[f+2];for(let h of n)for(let d=0;d<h.length;d+=3){let[f,p,x]=[u(a,h,d),u(l,h,d),u(c,h,d)],[g,m]=[t[0]*x,t[1]*x],_=[f+g,g-f,p+m,m-p,x,-x];for(let b=0;b<f0;b++)_[b]>s[b]&&(s[b]=_[b])}return s.map((h,d)=>h+o[d])}function p0(n){return n.reduce((e,t)=>e.map((i,s)=>Math.max(i,t[s])))}function VA(n){let e=(i,s)=>i.slice(Math.max(0,s-d0),s+d0+1),t=n.map((i,s)=>p0(e(n,s)));return n.map((i,s)=>{let r=e(t,s);return r[0].map((o,a)=>r.reduce((l,c)=>l+c[a],0)/r.length)})}function GA(n,e){let t=Math.min(n.length-2,Math.max(0,Math.floor(e))),i=Math.min(1,Math.max(0,e-t));return n[t].map((s,r)=>s+i*(n[t+1][r]-s))}var m0=28,HA=1.05,g0=Math.PI/24,WA=1.15,Pr=[{name:"3-D",text:"obliquely from above",towards:[.37,-.695,.616]},{name:"top",text:"from above",towards:[0,-5e-4,1]},{name:"side",text:"from the side, along the flat plane",towards:[0,-1,1e-4]},{name:"along",text:"from the far end, along the centre line",towards:[1,0,1e-4]}];function x0(n,e,t,i,s=nr()){let{size:r,target:o}=$A(e),a=e.map((E,A)=>A),l=hf(e,a,t),c=a.map(E=>hf(e,[E],t)),u=new Yn(m0,1,.02*r,60*r);u.up.set(0,0,1);let h=new yu(u,n);h.minDistance=.1*r,h.maxDistance=20*r;let d=null;function f(E=0){let A=s.oneScale?l:c[E],y=Math.tan(m0*Math.PI/360)/HA;d=A(s.towards,u.up,[y*u.aspect,y],s.following),s.oneScale&&(d.distance*=s.scale),h.target.copy(d.target).addScaledVector(s.aside,d.distance),u.position.copy(h.target).addScaledVector(s.towards,s.closer*d.distance),u.lookAt(h.target),u.updateMatrixWorld()}function p(){f(),i()}h.addEventListener("change",()=>{let E=u.position.clone().sub(h.target);s.closer=E.length()/d.distance,s.towards.copy(E).normalize(),s.aside.copy(h.target).sub(d.target).divideScalar(d.distance),p()});let x=E=>{document.activeElement!==n&&!E.ctrlKey&&E.stopImmediatePropagation()};n.parentElement.addEventListener("wheel",x,{capture:!0});function g({towards:E}){s.towards.set(...E).normalize(),s.closer=1,s.aside.set(0,0,0),p()}function m(E,A){let y=s.towards.clone().applyAxisAngle(u.up,E*g0),M=new G().crossVectors(u.up,y).normalize(),I=y.clone().applyAxisAngle(M,-A*g0);s.towards.copy(Math.abs(I.z)<.9999?I:y),p()}function _(E){let A=s.closer*d.distance*WA**-E;s.closer=Math.min(h.maxDistance,Math.max(h.minDistance,A))/d.distance,p()}function b(E){Object.assign(s,E),p()}function v(E,A){u.aspect=E,u.updateProjectionMatrix(),h.rotateSpeed=A,h.panSpeed=A,p()}return{camera:u,controls:h,look:s,size:r,target:o,aim:f,show:g,turn:m,zoom:_,choose:b,resize:v,dispose:()=>h.dispose()}}function nr(){return{towards:new G(...Pr[0].towards).normalize(),closer:1,aside:new G,following:!0,oneScale:!0,scale:1}}function $A(n){let e=new G(1/0,1/0,1/0),t=new G(-1/0,-1/0,-1/0),i=new G;for(let r of n){let o=Math.max(1,Math.floor(r.time.length/60));for(let a=0;a<r.time.length;a+=o){let l=r.pointsAt(r.time[a]);for(let c=0;c<l.length;c+=3)i.fromArray(l,c),e.min(i),t.max(i)}}let s=e.clone().add(t).multiplyScalar(.5);return{target:s,size:t.distanceTo(s)||1}}function Io(n,e,{clientWidth:t,clientHeight:i}){let{x:s,y:r}=n.project(e);return[(s+1)/2*t,(1-r)/2*i]}var Za=1/0,df=1e-4;function _0(n,e,t){let i=new Set,s=n.readings.map(({unit:p})=>(p==="deg"?1:e.units.length)*Kp(p)),r={start:n.start,end:Math.max(n.end,n.start+1),origins:[0],whole:!0},o=t,a=t,l=0;function c(){l||=requestAnimationFrame(()=>{l=0;for(let p of i)p()})}let u=(p,x)=>p!==Za?n.pointsAt(p,x):x?(x.set(o.points),x):o.points,h={...n,marks:[],efforts:null,stressed:!1,reach:n.mesh.base.radius,pointsAt:u,verticesAt:(p,x)=>p===Za?n.verticesOf(o.points,x):n.verticesAt(p,x),valuesAt(p,x,g){if(x!==Za)return n.valuesAt(p,x,g);let m=n.readings.findIndex(b=>b.name===p),_=p===Es?o.energies_J:o.readings[m].map(b=>s[m]*b);return g?(g.set(_),g):Float32Array.from(_)},restLengthsAt(p,x){p===Za?x.set(o.restLengths_m):n.restLengthsAt(p,x)},markAt:()=>{}},d={get time(){return o.time_s},span:r,clipTime:(p,x=Za)=>x,timeAt:p=>r.start+p*(r.end-r.start),wayAt:()=>0,onChange(p){return i.add(p),c(),()=>i.delete(p)}};function f(p){o=p,!(p!==a&&!XA(p,a,df*h.reach))&&(a=p,c())}return{clip:h,clock:d,show:f,get frame(){return o}}}function XA(n,e,t){let i=(s,r,o)=>s.some((a,l)=>Math.abs(a-r[l])>o);return i(n.points,e.points,t)||n.readings.some((s,r)=>i(s,e.readings[r],df*Math.max(1,...s.map(Math.abs))))||i(n.energies_J,e.energies_J,df*Math.max(...e.energies_J))||i(n.restLengths_m,e.restLengths_m,0)}var qA=16,YA=6;function y0(n,e,t){let{lines:i}=e.creases,[s,r]=[n.canvas,n.cells[0]],o=S("p",{className:"crease-label","aria-hidden":"true",hidden:!0}),a=S("span",{className:"crease-mark","aria-hidden":"true",hidden:!0});r.append(a,o);let l=S("select",{},S("option",{value:""},"none"),...i.map(({name:y},M)=>S("option",{value:String(M)},y))),c=S("output",{"aria-live":"off"}),u=S("span",{},"or point at one in the picture, or touch it"),h=new G,d=null,f=null,p=null;function x(y){return Io(h.fromArray(n.views[0].shape.vertices,3*y),n.eye.camera,r)}function g(y){let M=s.getBoundingClientRect(),I=[y.clientX-M.left,y.clientY-M.top],[L,C]=[null,qA];for(let[D,{ends:k}]of i.entries()){let N=ZA(I,...k.map(x))+m(k);N<C&&([L,C]=[D,N])}return L}let m=y=>h.fromArray(_(y)).distanceTo(n.eye.camera.position)/(1e3*n.eye.size);function _(y){let{vertices:M}=n.views[0].shape;return[0,1,2].map(I=>(M[3*y[0]+I]+M[3*y[1]+I])/2)}function b(y){let{lines:M,columns:I}=e.creases,L=e.valuesAt(af,t.clipTime(0));return M[y].columns.map(C=>{let{name:D,unit:k}=I[C],N=k==="°"?`${Nn(L[C],1)}°`:`${bt(Number(L[C].toPrecision(3)))} ${k}`;return`${D} ${N}`}).join(", ")}function v(){let y=f??d;if(o.hidden=a.hidden=y===null,c.textContent=d===null?"":b(d),u.hidden=d!==null,y===null)return;o.textContent=`${i[y].name}: ${b(y)}`;let[M,I]=i[y].ends.map(x),L=Math.hypot(I[0]-M[0],I[1]-M[1]),C=Math.atan2(I[1]-M[1],I[0]-M[0]);a.style.width=`${L.toFixed(1)}px`,a.style.transform=`translate(${M[0].toFixed(1)}px, ${M[1].toFixed(1)}px) rotate(${C.toFixed(4)}rad)`}let E=y=>{y!==f&&(f=y,v())},A=y=>{d=y,l.value=y===null?"":String(y),v()};return s.addEventListener("pointermove",y=>{y.pointerType==="mouse"&&E(y.buttons?null:g(y))}),s.addEventListener("pointerleave",()=>E(null)),s.addEventListener("pointerdown",y=>{p=y.isPrimary?[y.clientX,y.clientY]:null}),s.addEventListener("pointerup",y=>{if(!p||Math.hypot(y.clientX-p[0],y.clientY-p[1])>YA)return;let M=g(y);A(M===d?null:M)}),l.addEventListener("change",()=>A(l.value===""?null:Number(l.value))),n.onDraw(v),S("div",{className:"crease-choice"},S("label",{},`${e.creases.kind} `,l),c,u)}function ZA([n,e],[t,i],[s,r]){let[o,a]=[s-t,r-i],l=Math.min(1,Math.max(0,((n-t)*o+(e-i)*a)/(o*o+a*a||1)));return Math.hypot(n-t-l*o,e-i-l*a)}var KA=[["space","play or pause"],["← →","short step back or forward"],["page down, page up","long step back or forward"],["home, end","start, end"]],JA="shift with ← → ↑ ↓",jA=[["+ −","nearer, further"],["0","reset the view"]];function vu(n,e){let i=(n.length===1?n[0].marks:[]).map((r,o)=>[String(o+1),r.name]),s=[...KA,...i,[JA,`turn the ${e}`],...jA].map(([r,o])=>S("tr",{},S("th",{scope:"row"},r),S("td",{},o)));return S("details",{className:"keys"},S("summary",{},"Keys"),S("table",{},S("tbody",{},...s)),S("p",{},"Space and arrow keys work unless another control has the focus. All other keys work only in the player."))}var v0={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function b0({key:n,shiftKey:e},t,i,s){if(e&&n in v0)t.turn(...v0[n]);else if(s)if(n==="+"||n==="=")t.zoom(1);else if(n==="-"||n==="−")t.zoom(-1);else if(n==="0")t.show(i);else return!1;else return!1;return!0}function S0(n,e,t){n.addEventListener("keydown",i=>{!i.ctrlKey&&!i.metaKey&&!i.altKey&&b0(i,e,t,!0)&&i.preventDefault()})}function bu(n,e,t,i,s){let r={ArrowLeft:-1,ArrowRight:1,PageUp:10,PageDown:-10};function o(c){t.pause(),c()}function a(c,u){let{key:h}=c;if(b0(c,i,s,u))return!0;if(h in r)o(()=>t.step(r[h]));else if(h===" ")t.playing?t.pause():t.play();else if(h==="Home")o(()=>t.seek(t.span.start));else if(h==="End")o(()=>t.seek(t.span.end));else if(u)if(e.length===1&&e[0].marks[Number(h)-1])o(()=>t.seekClip(0,e[0].marks[Number(h)-1].time));else return!1;else return!1;return!0}function l(c){let u=document.activeElement,h=n.contains(u);!(h||u===document.body||u===null)||c.ctrlKey||c.metaKey||c.altKey||u instanceof HTMLSelectElement||u?.dataset?.keys==="own"||c.key===" "&&/^(BUTTON|SUMMARY|A)$/.test(u?.tagName??"")||u===document.body&&/^(Home|End|PageUp|PageDown)$/.test(c.key)||a(c,h)&&c.preventDefault()}return document.addEventListener("keydown",l),()=>document.removeEventListener("keydown",l)}var M0=2.4;function Ka(n){let e=10**Math.floor(Math.log10(n/M0));return e*[5,2,1].find(t=>t*e<=n/M0)}function w0(n,e){let t=Ka(n),i=t*Math.ceil(1.25*n/t),s=[],[r,o]=[e.x,e.y].map(c=>t*Math.round(c/t));for(let c=-i;c<=i+t/2;c+=t)s.push(r+c,o-i,0,r+c,o+i,0,r-i,o+c,0,r+i,o+c,0);let a=new yn().setAttribute("position",new sn(s,3)),l=new br(a,new $s({transparent:!0,opacity:.5,depthWrite:!1}));return l.frustumCulled=!1,l}function ff(n,e,t,i){let s=i?["marks on the time line: the states of each run, in its colour"]:[];return S("ul",{className:"legend"},...n.map(({sample:r,text:o})=>r==="tendon"?eE(o,e):QA(r,o)),...n.some(({sample:r})=>r==="tendon")?[S("li",{},"slack tendons sag, drawn with their rest length")]:[],S("li",{},`squares of the grid: ${ks(Ka(t),"m")}`),...s.map(r=>S("li",{},r)))}function QA(n,e){let[t,i]=n.split(" "),s={mountain:{color:pu},valley:{color:mu},region:{background:Ya(i)}};return S("li",{className:t==="region"?"of-region":""},E0(t==="region"?"panel":t,s[t]??{}),e)}function eE(n,e){return pf(n,"0",Ro,`${bt(e.factor*e.largest_J)} ${e.unit}${e.orMore?" or more":""}`)}function pf(n,e,t,i){let s=E0("bar",{background:t.gradient});return S("li",{className:"energy"},`${n}: `,S("span",{className:"whole"},e,s,i))}function A0(n){let e=S("span"),t=document.createElement("canvas").getContext("2d");t.font="14px system-ui, sans-serif";let i=new Map([...new Set(n)].map(o=>[o,t.measureText(o).width])),s=[...i.keys()].reduce((o,a)=>i.get(a)>i.get(o)?a:o),r=S("span",{className:"room","aria-hidden":"true"},s);return{element:S("span",{className:"roomy"},r,e),say:o=>{e.textContent=o}}}function E0(n,e){let t=S("span",{className:`swatch ${n}`,"aria-hidden":"true"});return Object.assign(t.style,e),t}function T0(n,e){if(!(e>n*(1+1e-6)))return 0;let[t,i]=[0,e/2];for(let s=0;s<40;s++){let r=(t+i)/2;tE(n,r)<e?t=r:i=r}return(t+i)/2}function tE(n,e){return e===0?n:Math.hypot(n,4*e)/2+n*n*Math.asinh(4*e/(n||1e-12))/(8*e)}function R0(n){let{triangles:e,faces:t,membraneLaw:i}=n.mesh,s=n.builtVertices(),r=Array.from({length:t.length},(h,d)=>C0(s,e,d)),o=new Float32Array(t.reduce((h,d)=>Math.max(h,d),0)+1),a=new Float32Array(t.length);function l(h,d){let{youngs_modulus_Pa:f,poisson_ratio:p}=i;return f/(1-p*p)*((1-p)*h+p*(h+d))}function c(h,d="strain"){o.fill(-1/0);for(let f=0;f<t.length;f++){let[p,x,g]=r[f],m=p*g-x*x;if(m<=1e-9*(p+g)**2)continue;let[_,b,v]=C0(h,e,f),E=(g*_-2*x*b+p*v)/(2*m),A=(_*v-b*b)/m,y=Math.sqrt(Math.max(E*E-A,0)),[M,I]=[(E+y-1)/2,(E-y-1)/2],L=d==="stress"?l(M,I):M;o[t[f]]=Math.max(o[t[f]],L)}for(let f=0;f<t.length;f++)a[f]=Math.max(0,o[t[f]]);return a}function u(h){let d=new Float32Array(s.length),f=0;for(let p of n.time)f=c(n.verticesAt(p,d),h).reduce((x,g)=>Math.max(x,g),f);return f}return{at:c,largest:u}}function C0(n,e,t){let[i,s,r]=[0,1,2].map(c=>3*e[3*t+c]),[o,a,l]=[0,0,0];for(let c=0;c<3;c++){let u=n[s+c]-n[i+c],h=n[r+c]-n[i+c];o+=u*u,a+=u*h,l+=h*h}return[o,a,l]}var nE=.9,P0=.4,iE=.02,sE=["crease","rim","edge"],ir=12;function mf(n,e){let{mesh:t}=n,i=new Float32Array(3*t.share.length),s=new Float32Array(n.tendons),r=Math.max(0,...t.tubes.map(I=>I.radius)),[o,a]=[!1,!0].map(I=>oE(t,I)),l=I0(t.tubes.filter(I=>I.kind==="bar"),20,0),c=I0(t.tubes.filter(I=>sE.includes(I.kind)),8,.4*r),u=aE(n,2.4*r),h=cE(t.base),d=n.efforts?a0(n):null,f=n.strained?R0(n):null,p=null,x=uE(t),g=new Bn;g.add(h.object,a.object,l.object,x.object,c.object,u.object,o.object),d&&g.add(d.group);let m=rE(o.object,a.object,l.object),_=[0,0,0],b=new $e;function v(I){n.verticesAt(I,i),o.pose(i),a.pose(i);for(let C of[l,c,x])C.pose(i);n.valuesAt(Es,I,s);let L=s.map(C=>e>0?C/e:0);u.pose(i,I,C=>P0+(1-P0)*Math.min(1,Math.max(0,L[C])/iE));for(let C=0;C<n.tendons;C++)Ro.at(L[C],_),u.colour(C,b.setRGB(..._,"srgb"));n.tendons&&(u.object.instanceColor.needsUpdate=!0),d?.pose(I),p&&E()}function E(){let I=f.at(i,p.quantity),L=[0,0,0];for(let C of[o,a])C.colour(D=>b.setRGB(...gu.at(I[D]/p.largest,L),"srgb"))}function A(I,L){p=f&&I?{quantity:I,largest:L}:null;for(let C of[o,a])C.flat(p!==null),p||C.colour(D=>b.set(Ya(t.regions[D])));p&&E()}function y(){for(let I of[l,c,x,h])I.paint();d?.paint(),m.children[0].material.color.set(_t("--shadow"))}function M(){for(let I of[l,c,u,x])I.object.dispose();for(let I of[o,a])I.dispose();d?.dispose(),h.dispose();for(let I of[l,c,u,x])I.object.geometry.dispose(),I.object.material.dispose();m.children[0].material.dispose()}return{group:g,shadow:m,pose:v,paint:y,sort:o.sort,vertices:i,tendons:u.object,efforts:d,strains:f,colourSheets:A,dispose:M}}function rE(...n){let e=new vr({side:zn,transparent:!0,opacity:.12,depthWrite:!1,stencilWrite:!0,stencilRef:1,stencilFunc:Pd,stencilZPass:Rd}),t=new Bn;for(let i of n){let s=i.isInstancedMesh?new di(i.geometry,e,i.count):new On(i.geometry,e);i.isInstancedMesh&&(s.instanceMatrix=i.instanceMatrix),s.frustumCulled=!1,t.add(s)}return t.scale.z=1e-5,t}function oE(n,e){let t=n.regions.flatMap((v,E)=>n.solid[v]===e?[E]:[]),i=t.flatMap(v=>n.triangles.slice(3*v,3*v+3)),s=t.length,r=new an(new Float32Array(3*i.length),3).setUsage(Ha),o=new an(new Float32Array(3*i.length),3).setUsage(Ha),a=new an(new Uint32Array(i.length),1).setUsage(Ha);for(let v=0;v<i.length;v++)a.array[v]=v;let l=new yn;l.setAttribute("position",r),l.setAttribute("color",o),l.setIndex(a);let c=new Ss({vertexColors:!0,side:zn,flatShading:!0,transparent:!e,opacity:e?1:nE,depthWrite:e,forceSinglePass:!0});c.onBeforeCompile=v=>{v.fragmentShader=v.fragmentShader.replace("#include <color_fragment>",`#include <color_fragment>
if (!gl_FrontFacing) diffuseColor.rgb *= 0.84;`)};let u=new vr({vertexColors:!0,side:zn}),h=new On(l,c);h.frustumCulled=!1,h.renderOrder=e?0:1;let d=new $e;f(v=>d.set(Ya(n.regions[v])));function f(v){for(let[E,A]of t.entries()){let y=v(A);for(let M=0;M<3;M++)y.toArray(o.array,9*E+3*M)}o.needsUpdate=!0}let p=v=>{h.material=v?u:c};function x(){l.dispose(),c.dispose(),u.dispose()}function g(v){for(let E=0;E<i.length;E++)for(let A=0;A<3;A++)r.array[3*E+A]=v[3*i[E]+A];r.needsUpdate=!0}let m=new Float32Array(s),_=Array.from({length:s},(v,E)=>E);function b(v){let E=r.array;for(let A=0;A<s;A++){let y=0;for(let M=0;M<3;M++){let I=9*A+M;y+=((E[I]+E[I+3]+E[I+6])/3-v.getComponent(M))**2}m[A]=y}_.sort((A,y)=>m[y]-m[A]);for(let A=0;A<s;A++)for(let y=0;y<3;y++)a.array[3*A+y]=3*_[A]+y;a.needsUpdate=!0}return{object:h,pose:g,sort:b,colour:f,flat:p,dispose:x}}function I0(n,e,t){let i=new di(new ji(1,1,1,e),Cr(t),n.length);i.frustumCulled=!1,o();let s=n.map(a=>[3*a.ends[0],3*a.ends[1],a.radius]);function r(a,l=()=>1){let c=i.instanceMatrix.array;for(let[u,[h,d,f]]of s.entries())Co(a,h,d,l(u)*f,c,16*u);i.instanceMatrix.needsUpdate=!0}function o(){let a={M:new $e(pu),V:new $e(mu),B:new $e(_t("--bar"))};for(let[l,{crease:c,region:u}]of n.entries())i.setColorAt(l,u===void 0?a[c]:new $e(Qg(u)));n.length&&(i.instanceColor.needsUpdate=!0)}return{object:i,pose:r,paint:o}}function aE(n,e){let t=n.mesh.tubes.filter(l=>l.kind==="tendon"),i=new di(new ji(1,1,1,12),Cr(e),t.length*ir);i.frustumCulled=!1;let s=new Float32Array(t.length),r=new Float32Array(3*(ir+1));function o(l,c,u){n.restLengthsAt(c,s);let h=i.instanceMatrix.array;for(let[d,{ends:f,radius:p}]of t.entries()){lE(l,3*f[0],3*f[1],s[d],r);for(let x=0;x<ir;x++)Co(r,3*x,3*x+3,u(d)*p,h,16*(d*ir+x))}i.instanceMatrix.needsUpdate=!0}function a(l,c){for(let u=0;u<ir;u++)i.setColorAt(l*ir+u,c)}return{object:i,pose:o,colour:a}}function lE(n,e,t,i,s){let r=[0,1,2].map(d=>n[t+d]-n[e+d]),o=Math.hypot(...r),a=T0(o,i),l=Math.abs(r[2])>.999*o?[1,0,0]:[0,0,-1],c=l.reduce((d,f,p)=>d+f*r[p],0)/(o*o||1),u=l.map((d,f)=>d-c*r[f]),h=Math.hypot(...u)||1;for(let d=0;d<=ir;d++){let f=d/ir,p=4*a*f*(1-f)/h;for(let x=0;x<3;x++)s[3*d+x]=n[e+x]+f*r[x]+p*u[x]}}function cE({rods:n,radius:e}){let t=new Float32Array(n.flat(2)),i=Cr(0),s=new di(new ji(1,1,1,16),i,n.length),r=new di(new _o(1,16,12),i,2*n.length),o=new Bn;for(let l of[s,r])l.frustumCulled=!1,o.add(l);for(let l=0;l<n.length;l++)Co(t,6*l,6*l+3,e,s.instanceMatrix.array,16*l);for(let l=0;l<2*n.length;l++){let c=r.instanceMatrix.array;for(let u=0;u<3;u++)[c[16*l+5*u],c[16*l+12+u]]=[e,t[3*l+u]];c[16*l+15]=1}function a(){for(let l of[s,r])l.dispose(),l.geometry.dispose();i.dispose()}return{object:o,paint:()=>i.color.set(_t("--base")),dispose:a}}function uE(n){let e=new di(new _o(1,16,12),Cr(0),n.joints.length);e.frustumCulled=!1;let t=()=>e.material.color.set(_t("--joint"));t();function i(s){let r=e.instanceMatrix.array;for(let[o,a]of n.joints.entries()){for(let l=0;l<3;l++)r[16*o+5*l]=n.jointRadius,r[16*o+12+l]=s[3*a+l];r[16*o+15]=1}e.instanceMatrix.needsUpdate=!0}return{object:e,pose:i,paint:t}}var L0="system-ui, -apple-system, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif";function Ja(n,e,t=1,[i,s]=[0,0]){n.save(),n.scale(t,t),n.translate(i,s);for(let r of e)N0(n,r);n.restore()}function N0(n,e){if(e.shapes){n.save(),e.kind==="moved"?n.translate(e.x,e.y):(n.beginPath(),n.rect(e.x,e.y,e.width,e.height),n.clip());for(let t of e.shapes)N0(n,t);n.restore();return}if(n.globalAlpha=e.opacity??1,n.setLineDash(e.dash??[]),n.lineWidth=e.lineWidth??1,e.kind==="text"){n.font=`${e.bold?"bold ":""}${e.size??12}px ${L0}`,n.textAlign={start:"left",middle:"center",end:"right"}[e.anchor??"start"],n.fillStyle=e.fill,n.fillText(e.text,e.x,e.y);return}if(n.beginPath(),e.kind==="rect"&&n.rect(e.x,e.y,e.width,e.height),e.kind==="circle"&&n.arc(e.x,e.y,e.r,0,2*Math.PI),e.kind==="path")for(let t of D0(e.points))for(let[i,s]of t.entries())n[i?"lineTo":"moveTo"](...s);(e.fill||e.scale)&&(n.fillStyle=e.scale?hE(n,e):e.fill,n.fill()),e.stroke&&(n.strokeStyle=e.stroke,n.stroke())}function hE(n,{x:e,width:t,scale:i}){let s=n.createLinearGradient(e,0,e+t,0);for(let[r,o]of i.entries())s.addColorStop(r/(i.length-1),o);return s}function D0(n){let e=[[]];for(let t of n)t?e.at(-1).push(t):e.at(-1).length&&e.push([]);return e.filter(t=>t.length)}function Mu(n,e,t,i){let s={count:0},r=[{kind:"rect",x:0,y:0,width:e,height:t,fill:"#ffffff"},...n].map(o=>Su(o,s));return[`<svg xmlns="http://www.w3.org/2000/svg" width="${Ut(e)}" height="${Ut(t)}" viewBox="0 0 ${Ut(e)} ${Ut(t)}" font-family="${L0}">`,`<title>${O0(i)}</title>`,...r,`</svg>
`].join(`
`)}function Su(n,e){if(n.kind==="svg")return`<svg ${`x="${Ut(n.x)}" y="${Ut(n.y)}" width="${Ut(n.width)}" height="${Ut(n.height)}"`} viewBox="${n.viewBox}"${n.stretched?' preserveAspectRatio="none"':""}>${n.content}</svg>`;if(n.scale){let h=`scale${++e.count}`,d=n.scale.map((f,p)=>`<stop offset="${Ut(p/(n.scale.length-1))}" stop-color="${f}"/>`);return`<linearGradient id="${h}">${d.join("")}</linearGradient>${Su({...n,scale:null,fill:`url(#${h})`},e)}`}if(n.kind==="moved")return`<g transform="translate(${Ut(n.x)} ${Ut(n.y)})">${n.shapes.map(h=>Su(h,e)).join(`
`)}</g>`;if(n.kind==="clip"){let h=`clip${++e.count}`;return`${`<clipPath id="${h}"><rect x="${Ut(n.x)}" y="${Ut(n.y)}" width="${Ut(n.width)}" height="${Ut(n.height)}"/></clipPath>`}<g clip-path="url(#${h})">${n.shapes.map(f=>Su(f,e)).join(`
`)}</g>`}let{fill:t="none",stroke:i,lineWidth:s=1,dash:r,opacity:o}=n,a=[`fill="${t}"`];i&&a.push(`stroke="${i}" stroke-width="${Ut(s)}" stroke-linejoin="round"`),r?.length&&a.push(`stroke-dasharray="${r.join(" ")}"`),o!==void 0&&o!==1&&a.push(`opacity="${o}"`);let{x:l,y:c}=n;return n.kind==="rect"?`<rect x="${Ut(l)}" y="${Ut(c)}" width="${Ut(n.width)}" height="${Ut(n.height)}" ${a.join(" ")}/>`:n.kind==="circle"?`<circle cx="${Ut(l)}" cy="${Ut(c)}" r="${Ut(n.r)}" ${a.join(" ")}/>`:n.kind==="path"?`<path d="${D0(n.points).map(d=>`M${d.map(f=>f.map(Ut).join(" ")).join("L")}`).join("")}" ${a.join(" ")}/>`:`<text ${n.turned?`transform="translate(${Ut(l)} ${Ut(c)}) rotate(-90)"`:`x="${Ut(l)}" y="${Ut(c)}"`} font-size="${n.size??12}"${n.bold?' font-weight="bold"':""} text-anchor="${n.anchor??"start"}" ${a.join(" ")}>${O0(n.text)}</text>`}var Ut=n=>String(Number(n.toFixed(2))),O0=n=>n.replace(/[&<>"]/g,e=>`&#${e.charCodeAt(0)};`);var wu=8,dE=["fill","stroke","stroke-width","stroke-dasharray","stroke-linejoin","stroke-linecap","opacity","font-size","font-weight","paint-order","text-anchor"],fE=new Set(["fill","stroke"]);function sr(n,e,t=null){for(let i of n)i.classList.add("paper");try{let i=n.map(c=>c.getBoundingClientRect()),[s,r]=[Math.min(...i.map(c=>c.left))-wu,Math.min(...i.map(c=>c.top))-wu],[o,a]=[Math.max(...i.map(c=>c.right))-s+wu,Math.max(...i.map(c=>c.bottom))-r+wu],l=n.flatMap(c=>xf(c,s,r,t));return{svg:Mu(l,o,a,e),width:o,height:a}}finally{for(let i of n)i.classList.remove("paper")}}function gf(n){n.classList.add("paper");try{let{left:e,top:t,width:i,height:s}=n.getBoundingClientRect();return{shapes:xf(n,e,t,null),width:i,height:s}}finally{n.classList.remove("paper")}}function xf(n,e,t,i){let s=getComputedStyle(n);if(s.display==="none"||s.visibility==="hidden"||i&&n.matches(i))return[];let r=n.getBoundingClientRect(),o={x:r.left-e,y:r.top-t,width:r.width,height:r.height};if(n.localName==="svg")return[{kind:"svg",...o,viewBox:n.getAttribute("viewBox"),stretched:n.getAttribute("preserveAspectRatio")==="none",content:xE(n)}];let a=[];r.width&&r.height&&a.push(...pE(s,o)),a.push(...mE(s,o));for(let l of n.childNodes)l.nodeType===Node.TEXT_NODE?a.push(...gE(l,s,e,t)):l.nodeType===Node.ELEMENT_NODE&&a.push(...xf(l,e,t,i));return a}function pE(n,e){let t=ja(n.backgroundColor),i=n.borderTopLeftRadius==="50%"&&e.width===e.height,s=[];t.opacity>0&&!i&&s.push({kind:"rect",...e,fill:t.text,opacity:t.opacity});let r=/^linear-gradient\(to right, (.*)\)$/.exec(n.backgroundImage);return r&&s.push({kind:"rect",...e,scale:r[1].match(/rgb\([^)]*\)/g)}),i&&s.push({kind:"circle",x:e.x+e.width/2,y:e.y+e.height/2,r:e.width/2-1,stroke:ja(n.borderTopColor).text,lineWidth:parseFloat(n.borderTopWidth),...t.opacity?{fill:t.text}:{}}),s}function mE(n,{x:e,y:t,width:i,height:s}){if(n.borderTopLeftRadius==="50%")return[];let r={Top:[[e,t],[e+i,t]],Right:[[e+i,t],[e+i,t+s]],Bottom:[[e,t+s],[e+i,t+s]],Left:[[e,t],[e,t+s]]};return Object.entries(r).flatMap(([o,a])=>{let[l,c]=[n[`border${o}Style`],parseFloat(n[`border${o}Width`])];if(l==="none"||!c)return[];let u=ja(n[`border${o}Color`]);return u.opacity?[{kind:"path",points:a,stroke:u.text,lineWidth:c,opacity:u.opacity,...l==="dashed"?{dash:[2*c,c]}:{}}]:[]})}function gE(n,e,t,i){let s=parseFloat(e.fontSize),r={size:s,bold:Number(e.fontWeight)>=600,fill:ja(e.color).text},o=document.createRange(),a=[];for(let{index:l,0:c}of n.data.matchAll(/\S+/g)){o.setStart(n,l),o.setEnd(n,l+c.length);let[u]=o.getClientRects();if(!u)continue;let h=a.at(-1),d=e.writingMode==="horizontal-tb";h&&Math.abs(d?h.box.top-u.top:h.box.left-u.left)<2?(h.words.push(c),h.last=u):a.push({words:[c],box:u,last:u})}return e.writingMode==="horizontal-tb"?a.map(({words:l,box:c})=>({kind:"text",x:c.left-t,y:c.top-i+c.height/2+.35*s,text:l.join(" "),...r})):a.map(({words:l,box:c,last:u})=>({kind:"text",x:(c.left+c.right)/2-t+.35*s,y:(Math.min(c.top,u.top)+Math.max(c.bottom,u.bottom))/2-i,text:l.join(" "),anchor:"middle",turned:!0,...r}))}function xE(n){let e=n.cloneNode(!0),[t,i]=[n,e].map(s=>[...s.querySelectorAll("*")]);for(let[s,r]of t.entries()){let o=getComputedStyle(r),a=i[s];for(let{name:l}of[...a.attributes])/^(aria-|data-|class$|role$|tabindex$|style$)/.test(l)&&a.removeAttribute(l);if(!(r.localName==="g"||r.localName==="title"))for(let l of dE){let c=o.getPropertyValue(l);if(!fE.has(l))a.setAttribute(l,c);else{let{text:u,opacity:h}=c==="none"?{text:"none",opacity:1}:ja(c);a.setAttribute(l,h?u:"none"),h&&h<1&&a.setAttribute(`${l}-opacity`,h)}}}return new XMLSerializer().serializeToString(e).replace(/^<svg[^>]*>|<\/svg>$/g,"")}function ja(n){let e=(n.match(/[\d.]+(?:e-?\d+)?%?/g)??[]).map(Number);return{text:`rgb(${(n.startsWith("color(")?e.slice(0,3).map(i=>255*i):e.slice(0,3)).map(Math.round).join(",")})`,opacity:e[3]??1}}function U0(n,e,t){let i=[];return{add:s=>i.push(_E(s)),bytes:()=>yE(i,n,e,Math.round(100*t))}}function _E(n){let e=new Uint16Array(n.length/4);for(let t=0;t<e.length;t++)e[t]=n[4*t]>>3<<10|n[4*t+1]>>3<<5|n[4*t+2]>>3;return e}function yE(n,e,t,i){let{palette:s,indexOf:r}=bE(n),o=[],a=c=>o.push(c&255,c>>8);o.push(...new TextEncoder().encode("GIF89a")),a(e),a(t),o.push(247,0,0,...s),o.push(33,255,11,...new TextEncoder().encode("NETSCAPE2.0"),3,1,0,0,0);let l=null;for(let c of n){let u=Uint8Array.from(c,(d,f)=>l&&l[f]===d?255:r[d]);o.push(33,249,4,5),a(i),o.push(255,0,44);for(let d of[0,0,e,t])a(d);o.push(0,8);let h=vE(u);for(let d=0;d<h.length;d+=255){let f=Math.min(d+255,h.length);o.push(f-d);for(let p=d;p<f;p++)o.push(h[p])}o.push(0),l=c}return o.push(59),Uint8Array.from(o)}function vE(n){let e=[],[t,i]=[0,0],s=9,r=258,o=new Int32Array(1048576).fill(-1),a=c=>{for(t|=c<<i,i+=s;i>=8;)e.push(t&255),t>>>=8,i-=8};a(256);let l=n[0];for(let c=1;c<n.length;c++){let u=l<<8|n[c];if(o[u]>=0){l=o[u];continue}a(l),r<4096?(o[u]=r,r===1<<s&&s<12&&s++,r++):(a(256),o.fill(-1),[s,r]=[9,258]),l=n[c]}return a(l),a(257),i&&e.push(t&255),e}function bE(n){let e=new Uint32Array(32768);for(let o of n)for(let a=0;a<o.length;a++)e[o[a]]++;let t=[...e.keys()].filter(o=>e[o]),i=[_f(t,e)];for(;i.length<255;){let o=i.reduce((c,u)=>u.spread>c.spread?u:c);if(!o.spread)break;let a=o.colours.sort((c,u)=>Au(c)[o.channel]-Au(u)[o.channel]),l=a.length>>1;i.splice(i.indexOf(o),1,_f(a.slice(0,l),e),_f(a.slice(l),e))}let s=new Uint8Array(3*256),r=new Uint8Array(32**3);for(let[o,{colours:a,weight:l}]of i.entries()){for(let c=0;c<3;c++){let u=a.reduce((h,d)=>h+e[d]*Au(d)[c],0)/l;s[3*o+c]=Math.round(u*255/31)}for(let c of a)r[c]=o}return{palette:s,indexOf:r}}var Au=n=>[n>>10,n>>5&31,n&31];function _f(n,e){let t=n.reduce((r,o)=>r+e[o],0),i=[0,1,2].map(r=>{let o=n.map(a=>Au(a)[r]);return o.reduce((a,l)=>Math.max(a,l))-o.reduce((a,l)=>Math.min(a,l))}),s=Math.max(...i);return{colours:n,weight:t,channel:i.indexOf(s),spread:s*s*Math.sqrt(t)}}var vf=8,k0=12.5,SE=25,ME=.6,[wE,F0,AE]=[640,1280,2400],yf=30,[Lo,EE,B0]=[10,210,24],TE=8,CE=["video/webm;codecs=vp9","video/webm;codecs=vp8","video/webm","video/mp4"];function Tu(n,e,t,i){let r=[us("PNG","download PNG of the picture",async()=>{let o=S("canvas");await V0(n,()=>n.drawSharp(AE,()=>Eu(o,n,t(),i(),n.canvas.width)));let a=await new Promise(l=>o.toBlob(l,"image/png"));mr(a,`${qn("picture")}.png`)})];if(e.seek&&e.timeAt){r.push(z0("GIF","gif",l=>PE(n,e,t,i,l)));let o=CE.find(l=>globalThis.MediaRecorder?.isTypeSupported(l)),a=o?.startsWith("video/mp4")?"MP4":"WebM";o&&HTMLCanvasElement.prototype.captureStream&&r.push(z0(a,a.toLowerCase(),l=>IE(n,e,t,i,l,o)))}return S("span",{className:"films",role:"group","aria-label":"save"},...r)}function z0(n,e,t){let i=null,s=us(n,`download a film as ${n}`,async()=>{if(i){i.stopped=!0;return}i={stopped:!1,progress:r=>{s.textContent=`${Math.round(100*r)} %`}};try{let r=await t(i);i.stopped||mr(r,`${qn("motion")}.${e}`)}finally{i=null,s.textContent=n}});return s}async function V0(n,e){let t=nf();n.paint();try{return await e()}finally{t(),n.paint()}}async function G0(n,e,t,i){let s=e.time;e.pause?.(),await V0(n,async()=>{for(let r=t();r!==null;r=t())e.seek(e.timeAt(Math.min(1,r))),await RE(),i(r)}),e.seek(s)}var RE=()=>new Promise(n=>requestAnimationFrame(n));async function PE(n,e,t,i,s){let r=S("canvas"),o=Math.round(vf*k0),[a,l]=[0,null];return await G0(n,e,()=>s.stopped||a>o?null:a/o,c=>{Eu(r,n,t(),i(),wE),l??=U0(r.width,r.height,1/k0),l.add(r.getContext("2d",{willReadFrequently:!0}).getImageData(0,0,r.width,r.height).data),s.progress(c),a++}),s.stopped?null:new Blob([l.bytes()],{type:"image/gif"})}async function IE(n,e,t,i,s,r){let o=S("canvas");Eu(o,n,t(),i(),F0);let a=new MediaRecorder(o.captureStream(SE),{mimeType:r,videoBitsPerSecond:8e6}),l=[];a.ondataavailable=({data:d})=>l.push(d);let c=new Promise(d=>{a.onstop=d});a.start();let u=performance.now(),h=()=>(performance.now()-u)/1e3;return await G0(n,e,()=>s.stopped||h()>vf+ME?null:h()/vf,d=>{Eu(o,n,t(),i(),F0),s.progress(Math.min(1,d))}),a.stop(),await c,new Blob(l,{type:r.split(";")[0]})}function Eu(n,e,t,i,s){let{canvas:r,cells:o}=e,a=s/r.clientWidth,l=Math.round(a*r.clientHeight),c=Math.max(1,a),u=LE(t,i,s/c),h=Math.round(c*u.height),d=[2*Math.round(s/2),2*Math.round((l+h)/2)];(n.width!==d[0]||n.height!==d[1])&&([n.width,n.height]=d);let f=n.getContext("2d",{willReadFrequently:!0});if(f.fillStyle="#ffffff",f.fillRect(0,0,...d),f.drawImage(r,0,0,s,l),o.length>1)for(let p of o)Ja(f,gf(p).shapes,a,[p.offsetLeft,p.offsetTop]);Ja(f,u.shapes,c,[0,l/c])}function LE(n,e,t){let i=[{kind:"text",x:Lo,y:20,text:n.text,bold:!0,size:14,fill:"#16191d"}],[s,r]=[n.longest?Math.max(EE,Lo+TE*n.longest+B0):Lo,0];for(let{shapes:o,width:a,height:l}of e.map(gf))s>Lo&&s+a>t-Lo&&([s,r]=[Lo,r+yf]),i.push({kind:"moved",x:s,y:r+(yf-l)/2,shapes:o}),s+=a+B0;return{shapes:i,height:r+yf}}var NE=[{quantity:null,name:"panels"},{quantity:"strain",name:"strain",text:"largest Green strain of the membrane",value:n=>`${bt(100*n)} %`},{quantity:"stress",name:"stress",text:"largest stress of the membrane (second Piola-Kirchhoff)",value:(n,e)=>ks(n,e)}];function bf(n,e,t){let i=S("li",{className:"energy",hidden:!0});e.append(i);let s=t.find(a=>a.stressed)?.mesh.membraneLaw.unit,o=NE.filter(({quantity:a})=>a!=="stress"||t.every(l=>l.stressed||!l.strained)).map(({quantity:a,name:l,text:c,value:u},h)=>{let d=S("button",{type:"button","aria-pressed":String(h===0)},l);return d.addEventListener("click",()=>{let f=n.colourSheets(a);a&&i.replaceChildren(...pf(c,"0",gu,u(f,s)).childNodes),i.hidden=!a;for(let p of e.querySelectorAll(".of-region"))p.hidden=!!a;for(let p of o)p.setAttribute("aria-pressed",String(p===d))}),d});return S("div",{className:"colours",role:"group","aria-label":"colour of the sheet"},"colour:",S("span",{},...o))}var H0=2,DE=.84,Cu=1024,OE=Uint8Array.from({length:Cu+1},(n,e)=>{let t=e/Cu;return Math.round(255*(t<=.0031308?12.92*t:1.055*t**(1/2.4)-.055))}),Sf=n=>OE[Math.min(Cu,Math.max(0,Math.round(Cu*n)))];function W0(n){let e=n.getContext("2d"),t=document.createElement("canvas"),i={frame:0,calls:0,triangles:0},s=1,r=[0,0,1,1];return{info:{render:i},setPixelRatio(o){s=o},setSize(o,a){[n.width,n.height]=[Math.floor(o*s),Math.floor(a*s)]},setScissorTest(){},setScissor(){},setViewport(...o){r=o.map(a=>a*s)},clear(){i.frame+=1,e.clearRect(0,0,n.width,n.height)},render(o,a){let[l,c]=[Math.round(r[2]*H0),Math.round(r[3]*H0)];if(l<1||c<1)return;let u=UE(o,a,l,c);[t.width,t.height]=[l,c],t.getContext("2d").putImageData(u,0,0),e.drawImage(t,r[0],n.height-r[1]-r[3],r[2],r[3])},dispose(){},forceContextLoss(){}}}function UE(n,e,t,i){let s=new ImageData(t,i),r={width:t,height:i,colours:new Uint32Array(s.data.buffer),depths:new Float32Array(t*i).fill(1/0)};n.updateMatrixWorld(),e.updateMatrixWorld();let o=kE(n),a=new at().multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),l=[];n.traverseVisible(u=>{u.geometry&&!Mf(u)[0].stencilWrite&&l.push(u)});for(let u of l.filter(h=>h.isLineSegments))GE(u,a,r);let c={projection:a,view:e.matrixWorldInverse,perspective:e.projectionMatrix,position:e.position};for(let u of l.filter(h=>h.isMesh))BE(u,c,o,r);return s}var Mf=({material:n})=>Array.isArray(n)?n:[n];function kE(n){let e={towards:new G(0,0,1),sun:new $e(0),sky:new $e(0),ground:new $e(0)};return n.traverse(t=>{t.isDirectionalLight&&(e.towards.copy(t.position).normalize(),e.sun.copy(t.color).multiplyScalar(t.intensity/Math.PI)),t.isHemisphereLight&&(e.sky.copy(t.color).multiplyScalar(t.intensity/Math.PI),e.ground.copy(t.groundColor).multiplyScalar(t.intensity/Math.PI))}),e}function FE(n,e,t,i,s){if(t.isMeshBasicMaterial){for(let h=0;h<3;h++)s[h]=Sf(e[h]);return}let r=Math.max(0,n.dot(i.towards)),o=.5*n.y+.5,a=t.emissive&&t.emissiveIntensity?t.emissive.toArray().map(h=>h*t.emissiveIntensity):null,[l,c,u]=[i.sun,i.sky,i.ground].map(h=>[h.r,h.g,h.b]);for(let h=0;h<3;h++)s[h]=Sf(e[h]*(r*l[h]+o*c[h]+(1-o)*u[h])+(a?.[h]??0))}function BE(n,e,t,i){let{geometry:s}=n,r=Mf(n),o={start:0,count:s.index?.count??s.attributes.position.count,materialIndex:0},a=Array.isArray(n.material)?s.groups:[o],l=n.isInstancedMesh?n.count:1,[c,u,h]=[new at,new at,new $e];for(let d=0;d<l;d++){c.copy(n.matrixWorld),h.set(1,1,1),n.isInstancedMesh&&(n.getMatrixAt(d,u),c.multiply(u),n.instanceColor&&n.getColorAt(d,h));for(let f of a)zE(s,f,c,r[f.materialIndex],h,e,t,i)}}function zE(n,{start:e,count:t},i,s,r,o,a,l){let{position:c,normal:u,color:h}=n.attributes,d=u&&!s.flatShading,f=[s.color.r*r.r,s.color.g*r.g,s.color.b*r.b],p=new et().getNormalMatrix(i),x=s.userData.nearer??0,g=new Map,m=new Ft,_=new G;function b(L){if(g.has(L))return g.get(L);_.fromBufferAttribute(c,L).applyMatrix4(i);let C=_.clone();m.set(_.x,_.y,_.z,1).applyMatrix4(o.projection);let D={place:C,x:(m.x/m.w+1)/2*l.width,y:(1-m.y/m.w)/2*l.height,depth:m.z/m.w,behind:m.w<=0,normal:d?new G().fromBufferAttribute(u,L).applyMatrix3(p).normalize():null};return x&&(_.applyMatrix4(o.view),_.addScaledVector(_.clone().normalize(),-x),m.set(_.x,_.y,_.z,1).applyMatrix4(o.perspective),D.depth=m.z/m.w),g.set(L,D),D}let[v,E,A,y]=[new G,new G,new G,new G],M=[0,0,0],I=[[0,0,0],[0,0,0],[0,0,0]];for(let L=e;L+2<e+t;L+=3){let C=[0,1,2].map(N=>n.index?n.index.getX(L+N):L+N),D=C.map(b);if(D.some(N=>N.behind))continue;v.subVectors(D[1].place,D[0].place),E.subVectors(D[2].place,D[0].place),A.crossVectors(v,E).normalize(),y.subVectors(o.position,D[0].place);let k=A.dot(y)<0;k&&A.negate();for(let N=0;N<3;N++){let B=C[N];for(let $=0;$<3;$++)M[$]=f[$]*(h?h.getComponent(B,$):1)*(k&&h&&!s.isMeshBasicMaterial?DE:1);FE(d?D[N].normal:A,M,s,a,I[N])}VE(D,I,l)}}function VE([n,e,t],i,{width:s,height:r,colours:o,depths:a}){let l=(e.x-n.x)*(t.y-n.y)-(e.y-n.y)*(t.x-n.x);if(Math.abs(l)<1e-9)return;let[c,u]=[Math.max(0,Math.floor(Math.min(n.x,e.x,t.x))),Math.min(s-1,Math.ceil(Math.max(n.x,e.x,t.x)))],[h,d]=[Math.max(0,Math.floor(Math.min(n.y,e.y,t.y))),Math.min(r-1,Math.ceil(Math.max(n.y,e.y,t.y)))],[f,p,x]=i,g=f.every((v,E)=>v===p[E]&&v===x[E]),m=4278190080|f[2]<<16|f[1]<<8|f[0],[_,b]=[(t.y-n.y)/l,(n.y-e.y)/l];for(let v=h;v<=d;v++){let[E,A]=[c+.5-n.x,v+.5-n.y],y=(E*(t.y-n.y)-A*(t.x-n.x))/l,M=(A*(e.x-n.x)-E*(e.y-n.y))/l,I=v*s+c;for(let L=c;L<=u;L++,I++,y+=_,M+=b){let C=1-y-M;if(C<0||y<0||M<0)continue;let D=C*n.depth+y*e.depth+M*t.depth;D>=a[I]||(a[I]=D,o[I]=g?m:4278190080|C*f[2]+y*p[2]+M*x[2]<<16|C*f[1]+y*p[1]+M*x[1]<<8|C*f[0]+y*p[0]+M*x[0])}}}function GE(n,e,{width:t,height:i,colours:s}){let{position:r}=n.geometry.attributes,[o]=Mf(n),[a,l,c]=[o.color.r,o.color.g,o.color.b].map(Sf),u=Math.round(255*o.opacity)<<24|c<<16|l<<8|a,h=[0,1].map(()=>new Ft);for(let d=0;d+1<r.count;d+=2){for(let[g,m]of h.entries())m.set(r.getX(d+g),r.getY(d+g),r.getZ(d+g),1).applyMatrix4(n.matrixWorld).applyMatrix4(e);if(h.some(g=>g.w<=0))continue;let[f,p]=h.map(g=>[(g.x/g.w+1)/2*t,(1-g.y/g.w)/2*i]),x=Math.min(2e4,Math.ceil(Math.max(Math.abs(p[0]-f[0]),Math.abs(p[1]-f[1]))));for(let g=0;g<=x;g++){let[m,_]=[0,1].map(b=>Math.floor(f[b]+g/(x||1)*(p[b]-f[b])));m>=0&&m<t&&_>=0&&_<i&&(s[_*t+m]=u)}}}var $0=4096,HE=3.2,WE=new G(-.45,.75,1),$E=.42*Math.PI,XE=.64*Math.PI,qE=.5,YE=.14;function Qa(n,e,t,i,s){let r=S("canvas",{tabIndex:0,role:"img","aria-label":`${i} ${KE}`}),o=r.getContext("webgl2",{antialias:!0,alpha:!0,stencil:!0}),a=n.map(()=>S("div",{className:"cell"})),l=n.length>1,c=S("div",{className:l?"stage several":"stage"},r,...a);c.style.setProperty("--columns",String(n.length===4?2:Math.min(n.length,n.length>6?4:3)));let u=()=>l?Math.ceil(HE*parseFloat(getComputedStyle(a[0]).fontSize)):0,h=o?new hu({canvas:r,context:o,antialias:!0,alpha:!0,stencil:!0}):W0(r);h.setScissorTest(!0);let d=x0(r,n,e,m,s),f=n.map(k=>JE(k,t(k),d)),p=0,x=!1,g=new Set;function m(){p||(p=requestAnimationFrame(b))}function _(){for(let[k,N]of f.entries())N.shape.pose(e.clipTime(k));x=!0}function b(){cancelAnimationFrame(p),p=0,x||_();let k=r.clientHeight,N=u();h.setScissor(0,0,r.clientWidth,k),h.setViewport(0,0,r.clientWidth,k),h.clear();for(let[B,$]of f.entries()){d.aim(B);let H=a[B],se=[H.offsetLeft,k-H.offsetTop-H.offsetHeight,H.offsetWidth,H.offsetHeight-N];h.setViewport(...se),h.setScissor(...se),$.light.position.copy(WE).applyQuaternion(d.camera.quaternion);let Y=d.camera.position.z>$.floor.position.z;$.floor.material.opacity=Y?qE:YE,$.shape.shadow.visible=Y,$.shape.sort(d.camera.position),h.render($.scene,d.camera)}d.aim();for(let B of g)B()}function v(){for(let k of f)k.floor.material.color.set(_t("--floor")),k.shape.paint();m()}function E(){let[k,N]=[c.clientWidth,c.clientHeight];if(!k||!N)return;h.setPixelRatio(Math.min(devicePixelRatio,2,$0/Math.max(k,N))),h.setSize(k,N,!1);let B=a[0].offsetHeight-u();d.resize(a[0].offsetWidth/B,N/B),b()}function A(k,N){let B=Math.min(k/c.clientWidth,$0/Math.max(c.clientWidth,c.clientHeight));h.setPixelRatio(B),h.setSize(c.clientWidth,c.clientHeight,!1),b();let $=N();return E(),$}let y=new ResizeObserver(E);y.observe(c);let M=e.onChange(()=>{x=!1,b()}),I=Qs(v);r.addEventListener("webglcontextrestored",m),v();function L(){cancelAnimationFrame(p),M(),I(),y.disconnect(),d.dispose();for(let{shape:k,floor:N}of f)k.dispose(),N.geometry.dispose(),N.material.dispose();h.dispose(),h.forceContextLoss(),c.remove()}function C(k){let N=k?f.reduce((B,{shape:$})=>Math.max(B,$.strains?.largest(k)??0),0):0;for(let{shape:B}of f)B.colourSheets?.(k,N||Number.MIN_VALUE);return m(),N}let D=o?null:S("p",{className:"note"},ZE);return{element:c,note:D,canvas:r,cells:a,eye:d,pose:_,draw:b,drawSharp:A,paint:v,views:f,colourSheets:C,onDraw:k=>g.add(k),statistics:()=>h.info.render,dispose:L}}var ZE="This browser has no WebGL: the processor draws the picture, without shadows and more slowly.",KE="Drag to turn, pinch to zoom; keys are listed below.";function JE(n,e,t){let i=w0(t.size,t.target);i.position.z=jE(n)-.06*t.size,e.shadow.position.z=i.position.z+.001*t.size;let s=new Na("#ffffff",$E),r=new _a;return r.add(e.group,e.shadow,i,s,new Pa("#ffffff","#dde2e8",XE)),{shape:e,floor:i,light:s,scene:r}}function jE(n){let e=1/0,t=Math.max(1,Math.floor(n.time.length/200));for(let i=0;i<n.time.length;i+=t){let s=n.pointsAt(n.time[i]);for(let r=2;r<s.length;r+=3)e=Math.min(e,s[r])}return e}var QE=.3,eT=4,tT=4,X0=[{name:"even motion",value:"even"},{name:"real time",value:1},{name:"1/2",value:1/2},{name:"1/5",value:1/5},{name:"1/10",value:1/10},{name:"1/20",value:1/20},{name:"1/50",value:1/50},{name:"1/100",value:1/100}];function q0(n,e){let t=nT(n,e),i=new Float64Array(t.length);for(let[l,c]of n.entries())iT(c,e.origins[l],t,i);for(let l=1;l<i.length;l++)i[l]+=i[l-1];let s=i[i.length-1],r=s>0?QE:1;for(let l=0;l<i.length;l++){let c=(t[l]-t[0])/(t[t.length-1]-t[0]||1);i[l]=r*c+(1-r)*(i[l]/(s||1))}let o=l=>l.drive!=="none"&&l.start-e.origins[0]<e.end&&l.end-e.origins[0]>e.start,a=n[0].stages.filter(o).length;return{seconds:e.seconds??eT+tT*a,wayAt:l=>tr(t,i,l),timeAt:l=>tr(i,t,l)}}function nT(n,e){let t=new Set([e.start,e.end]);for(let[i,s]of n.entries())for(let r of s.time){let o=r-e.origins[i];o>e.start&&o<e.end&&t.add(o)}return Float64Array.from(t).sort()}function iT(n,e,t,i){let s=n.pointsAt(t[0]+e).slice(),r=s.slice();for(let o=1;o<t.length;o++){n.pointsAt(t[o]+e,r);let a=0;for(let l=0;l<r.length;l+=3){let c=Math.hypot(r[l]-s[l],r[l+1]-s[l+1],r[l+2]-s[l+2]);c>a&&(a=c)}i[o]=Math.max(i[o],a),[s,r]=[r,s]}}var sT="M7 4.5v15l12-7.5z",rT="M7 5h3.5v14H7zM13.5 5H17v14h-3.5z",wf=1e4,oT=.02;function Ru(n,e){let t=S("button",{type:"button",className:"play"}),i=S("input",{type:"range",min:0,max:wf,step:1,"aria-label":e.span.unit?e.span.name:"time"}),s=S("div",{className:"bands","aria-hidden":"true"}),r=S("div",{className:"ticks","aria-hidden":"true"}),o=S("p",{className:n[0].along.length?"time long":"time"}),a=S("p",{className:"spoken",role:"status"}),l=S("div",{className:"states"}),c=null,u=[];function h(){n.length>1||n[0].marks===c||(c=n[0].marks,u=c.map(g=>lT(g,e)),l.replaceChildren(...u))}h();let d=S("div",{className:"transport"},S("div",{className:"line"},t,S("div",{className:"tracks"},...aT(n[0],e),S("div",{className:"track"},s,i,r))),S("div",{className:"choices"},o,l,...e.span.unit?[]:[cT(e)],...uT(e),a));t.addEventListener("click",()=>e.playing?e.pause():e.play()),i.addEventListener("input",()=>{e.pause(),e.seek(e.momentAt(i.value/wf))});let f={},p=null,x=0;return e.onChange(()=>{h();let{span:g,stretched:m}=e;(g!==f.span||m!==f.stretched)&&hT(n,e,s,r),f={span:g,stretched:m},i.value=Math.round(wf*e.shareAt(e.time)),i.setAttribute("aria-valuetext",Y0(n,e));let _=n.length===1?el(n[0],e.clipTime(0)):"",b=n.length===1?_&&` · ${_}`:e.span.label.replace("time",""),v=e.playing&&!e.span.unit?`, ${dT(e.slowness)}`:"";o.textContent=`${qi(e.time,e.span)}${b}${v}${Z0(n[0],e.clipTime(0)," · ")}`;for(let[E,A]of(c??[]).entries())u[E].setAttribute("aria-pressed",String(Math.abs(A.time-e.clipTime(0))<1e-9));e.playing!==p&&(t.replaceChildren(ml(e.playing?rT:sT)),t.setAttribute("aria-label",e.playing?"pause":"play"),p=e.playing),clearTimeout(x),e.playing||(x=setTimeout(()=>{a.textContent=Y0(n,e)},600))}),d}function aT(n,e){if(!n.along.length)return[];let t=Ih("",100),i=S("span",{className:"profile-ball"}),s=S("small"),r=c=>100*e.shareAt(c),o=null,a=null;function l(c){let u=n.line(c.key,0),[h,d]=[Math.min(0,...u),Math.max(...u)];o=p=>100-100*(p-h)/(d-h||1);let f=Array.from(u,(p,x)=>`${r(n.time[x]).toFixed(2)} ${o(p).toFixed(2)}`);t.querySelector("path").setAttribute("d",`M${f.join("L")}`),s.textContent=c.name,s.classList.toggle("at-start",u[0]<u.at(-1)),a=c}return e.onChange(()=>{let[c]=n.along;c!==a&&l(c);let u=e.clipTime(0);i.style.left=`${r(u).toFixed(2)}%`,i.style.top=`${o(n.valuesAt(c.key,u)[0]).toFixed(2)}%`}),[S("div",{className:"profile","aria-hidden":"true"},t,i,s)]}function lT(n,e){let t=S("button",{type:"button",className:"state"},S("b",{},n.letter),` ${n.name}`);return t.addEventListener("click",()=>{e.pause(),e.seekClip(0,n.time)}),t}function cT(n){let e=X0.map(({name:i,value:s})=>S("option",{value:String(s)},i)),t=S("select",{},...e);return t.addEventListener("change",()=>n.setSpeed(t.value==="even"?"even":Number(t.value))),S("label",{},"speed ",t)}function uT(n){if(n.spans.length<2)return[];let e=n.spans.map((i,s)=>S("option",{value:String(s)},i.name)),t=S("select",{},...e);return t.addEventListener("change",()=>n.setSpan(n.spans[Number(t.value)])),n.onChange(()=>{t.value=String(n.spans.indexOf(n.span))}),[S("label",{},"show ",t)]}function hT(n,e,t,i){let{span:s}=e,r=o=>Math.min(1,Math.max(0,e.shareAt(o)));t.replaceChildren(),i.replaceChildren();for(let[o,a]of n.entries()){let l=s.origins[o];for(let c of a.stages.filter(u=>u.driven&&n.length===1)){let[u,h]=[r(c.start-l),r(c.end-l)],d=S("span",{className:"band"});d.style.left=`${100*u}%`,d.style.width=`${100*(h-u)}%`,h>u&&t.append(d)}for(let c of a.marks){let u=c.time-l;if(u<s.start-1e-9||u>s.end+1e-9)continue;let[h,d]=[r(u),i.lastElementChild];if(d&&n.length===1&&h-d.at<oT){d.append(` ${c.letter}`);continue}let f=S("span",{className:"tick",at:h},n.length===1?c.letter:"");f.style.left=`${100*h}%`,n.length>1&&f.style.setProperty("--tick",`var(--line-${o%7})`),i.append(f)}}}function dT(n){return n<1.05?"real time":`${n<10?Nn(n,1):Math.round(n)} times slower`}function el(n,e){let t=n.markAt(e);return t?`${t.letter} ${t.name}`:n.stageAt(e).name}function Z0(n,e,t){let i=({name:s,unit:r,key:o})=>`${t}${s} ${bt(Number(n.valuesAt(o,e)[0].toPrecision(3)))} ${r}`;return n.along.map(i).join("")}function Y0(n,e){let t=n.map((i,s)=>{let r=e.clipTime(s);return`${n.length>1?`${i.name}: `:""}${el(i,r)||e.span.name}${Z0(i,r,", ")}${fT(i,r)}`});return`${qi(e.time,e.span)}: ${t.join("; ")}`}function fT(n,e){let[t]=n.readings;if(!t)return"";let i=n.markAt(e)?.readings[t.name]?.mean??n.valuesAt(t.name,e),s=t.unit==="deg"?"degrees":t.unit,r=[Math.min(...i),Math.max(...i)].map(a=>Nn(a,1)),o=i.length>1;return`, ${t.label}${o?"s":""} ${o?r.join(" to "):r[0]} ${s}`}function rr(n,e,t,{energy:i,legend:s,text:r,whole:o},a,l=e.length>1||!!a){let c=Qa(e,t,x=>mf(x,i.largest_J),r,a),u=S("div",{className:"picture"},c.element,...c.note?[c.note]:[],Iu(c.eye,l?o:null));e.length===1&&mT(c.cells[0],e[0],t);let h=[ff(s,i,c.eye.size,e.length>1?o:null)];e.some(x=>x.strained)&&h.unshift(bf(c,h[0],e)),e.length===1&&e[0].efforts?.drives.length&&gT(h.at(-1),e[0],t),e.length>1&&e.some(x=>x.efforts?.drives.some(g=>g.arrow))&&h.at(-1).append(S("li",{className:"effort"},J0(),"torque or force of a drive, while it acts"));let d=e.length===1&&e[0].creases?[y0(c,e[0],t)]:[];n.replaceChildren(u,Ru(e,t),...d,...h,vu(e,o)),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label",`the moving ${o}`),K0(n,c,t,()=>pT(e,t));let f=bu(n,e,t,c.eye,Pr[0]);function p(){t.pause(),f(),c.dispose(),n.replaceChildren()}return{stage:c,dispose:p}}function Pu(n,e,t,{energy:i,legend:s,text:r,whole:o},a){let l=Qa(e,t,h=>mf(h,i.largest_J),r,a),c=S("div",{className:"picture"},l.element,...l.note?[l.note]:[],Iu(l.eye,null,!a)),u=[ff(s,{...i,orMore:!0},l.eye.size,null)];return e.some(h=>h.strained)&&u.unshift(bf(l,u[0],e)),n.replaceChildren(c,...u),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label",`the ${o} as set by the sliders`),K0(n,l,t,()=>({text:"",longest:0})),S0(n,l.eye,Pr[0]),{stage:l}}function K0(n,e,t,i){let s=()=>[...n.querySelectorAll(".legend .energy:not([hidden])")];n.querySelector(".views").prepend(Tu(e,t,i,s))}function pT(n,e){let{span:t}=e,[i]=n,s=n.length===1?`${el(i,e.clipTime(0))}, `:"",r=n.length===1?[...i.stages.map(({name:c})=>c),...i.marks.map(({letter:c,name:u})=>`${c} ${u}`)]:[],o=c=>Math.max(0,...c.map(u=>u.length)),a=`${s}${qi(e.time,t)}`,l=[t.start,t.end].map(c=>qi(c,t));return{text:a,longest:Math.max(a.length,o(r)+2+o(l))}}function mT(n,e,t){let i=S("p",{className:"now","aria-hidden":"true"});n.append(i),t.onChange(()=>{i.textContent=el(e,t.clipTime(0)),i.hidden=!i.textContent})}function J0(){return S("span",{className:"swatch arrow","aria-hidden":"true"})}function gT(n,e,t){let i=e.efforts.drives.some(o=>o.arrow),s=o=>o0(e.efforts,o,bt).join("; ")||"no drive acts now",r=A0(Array.from(e.time,s));n.append(S("li",{className:"effort"},...i?[J0()]:[],r.element)),t.onChange(()=>r.say(s(t.clipTime(0))))}function Iu(n,e,t=!0){let i=Pr.map(l=>us(l.name,`${l.name}: view ${l.text}`,()=>n.show(l))),s=[["←","turn left",[-1,0]],["→","turn right",[1,0]],["↑","turn up",[0,1]],["↓","turn down",[0,-1]]].map(([l,c,u])=>us(l,c,()=>n.turn(...u))),r=(l,c,u)=>{let h=us(l,c,()=>{n.choose({[u]:!n.look[u]}),h.setAttribute("aria-pressed",String(n.look[u]))});return h.setAttribute("aria-pressed",String(n.look[u])),h},o=[...t?[r("follow","follow: keep the picture filled as the structure moves","following")]:[],...e?[r("one scale",`one scale: draw all ${e}s at the same scale`,"oneScale")]:[]],a=[us("+","nearer",()=>n.zoom(1)),us("−","further",()=>n.zoom(-1))];return S("div",{className:"views",role:"group","aria-label":"view"},...o.length?[S("span",{},...o)]:[],S("span",{},...i),S("span",{className:"turns"},...s),S("span",{},...a))}var xT=4,_T={deg:.05};function or(n,e,t,i,s=0,r=!1){let{heading:o,names:a}=e.mesh.parts,l=e.readings.map(b=>({name:b.name,title:b.row,parts:b.parts,text:v=>Af(v,b.unit),ofState:v=>v.readings[b.name]&&yT(v.readings[b.name],b.unit)})),c=b=>bt(i.factor*b);e.tendons&&l.push({name:Es,title:`tendon energy (${i.unit})`,parts:e.mesh.tendonParts,text:c,ofState:b=>b.tendonEnergy_J?.map(c)});let u=l.map(()=>a.map(()=>S("td"))),h=S("caption"),d=l.map(b=>b.title),f=a.length>xT,[p,x]=f?[d,a]:[a,d],g=S("tr",{},o?S("th",{scope:"col"},o):S("td"),...p.map(b=>S("th",{scope:"col"},b))),m=x.map((b,v)=>S("tr",{},S("th",{scope:"row"},b),...f?u.map(E=>E[v]):u[v])),_=S("table",{className:"numbers"},h,S("thead",{},g),S("tbody",{},...m));return n.replaceChildren(S("div",{className:"table"},_)),n.classList.add("readout"),t.onChange(()=>{let b=t.clipTime(s),v=e.markAt(b),E=v?`, ${v.name}${v.tendonEnergy_J?" (means)":""}`:"",A=r?`${e.name}: `:"",y=o?`every ${o}`:"all values";h.textContent=`${Ot(`${A}${y}`)} at ${qi(t.time,t.span)}${E}`;for(let[M,I]of l.entries()){let L=v&&I.ofState(v)||Array.from(e.valuesAt(I.name,b),I.text);for(let[C,D]of I.parts.entries())u[M][D].textContent=L[C]}})}function Af(n,e){return e==="deg"?Nn(n,1):bt(n)}function yT({mean:n,swing:e},t){return n.map((i,s)=>{let r=e[s]>(_T[t]??.005*Math.abs(i));return`${Af(i,t)}${r?` ± ${Af(e[s],t)}`:""}`})}var vT=0;function No(n=document){let e=new ResizeObserver(t=>{for(let{target:i}of t)if(j0(i),i.scrollWidth>i.clientWidth||i.scrollHeight>i.clientHeight)bT(i);else for(let s of["tabindex","role","aria-label","aria-labelledby"])i.removeAttribute(s)});for(let t of n.querySelectorAll(".table"))e.observe(t),t.addEventListener("scroll",()=>j0(t),{passive:!0})}function j0(n){let e=Math.abs(n.scrollLeft);n.classList.toggle("more-left",e>1),n.classList.toggle("more-right",e+n.clientWidth<n.scrollWidth-1)}function bT(n){let{caption:e}=n.querySelector("table");if(n.tabIndex=0,n.setAttribute("role","group"),!e){let t=[...n.querySelectorAll("thead th")].map(i=>i.textContent);return n.setAttribute("aria-label",t.join(", ")||"table")}return e.id||=`caption-${++vT}`,n.setAttribute("aria-labelledby",e.id)}function ST(n,e){let t=n.design.text.split(`
`);for(let{key:i,unit:s,factor:r,line:o}of n.knobs)i in e&&(t[o.number]=`${o.before}${ex(e[i],s,r)}${o.after}`);return t.join(`
`)}function Q0({knobs:n},e,t){let{unit:i,factor:s}=n.find(r=>r.key===e);return ex(t,i,s)}function ex(n,e,t){return`${Number((t*n).toPrecision(12))} ${e}`}function tx(n){let e=S("a",{className:"button",download:"design.toml"},"This setting as a design file"),t=S("code"),i=S("p",{className:"note"},"This page does not check the energy balance; a run of the file does."),s=S("div",{className:"setting"},e,S("pre",{},t),i);function r(o){let a=new TextEncoder().encode(ST(n,o));e.href=`data:application/toml;base64,${btoa(String.fromCharCode(...a))}`,t.textContent="forficula run design.toml"}return r({}),{element:s,refresh:r}}var nx=[["←","left","ArrowLeft",[-1,0]],["↑","up","ArrowUp",[0,1]],["↓","down","ArrowDown",[0,-1]],["→","right","ArrowRight",[1,0]]],tl=Object.fromEntries(nx.map(([,,n,e])=>[n,e])),Lu=n=>S("select",{},...n.map(([e,t])=>S("option",{value:t},e)));function Nu(n,{clicked:e,pressed:t}){let i=nx.map(([r,o,a])=>{let l=S("button",{type:"button",title:`${n} ${o}`,"aria-label":`${n} ${o}`,"data-way":a},r);return l.addEventListener("click",()=>e(a)),l}),s=S("span",{className:"pad",role:"group","aria-label":`${n} in the plane of the picture`},...i);return s.addEventListener("keydown",r=>{!(r.key in tl)||r.shiftKey||r.ctrlKey||r.metaKey||r.altKey||(r.preventDefault(),r.stopPropagation(),t(r.key))}),s}var MT=500,ix=[["a little",.1],["half",.5],["as strong as its drives",1]];function sx(n,e,t,i,s){let r=Lu(t.map((_,b)=>[_,b]).filter(([,_])=>e.movable[_])),o=S("select",{},...ix.map(([_,b])=>S("option",{value:b,selected:b===ix[0][1]},_))),a=S("span",{className:"note",role:"status"}),l=Nu("push",{clicked:m,pressed:g}),c=S("p",{className:"note"},"On these buttons, arrow keys push while they are held. Pressing a button pushes for half a second."),u=S("details",{className:"push-keys"},S("summary",{},"Push without a pointer"),S("div",{className:"choices"},S("label",{},"point ",r),S("label",{},"force ",o),l,a),c),h=wT(n,e,()=>Number(r.value),u),d=new Set,f=0;function p(){clearTimeout(f);let[_,b]=[0,1].map(A=>[...d].reduce((y,M)=>y+tl[M][A],0));if(!_&&!b){a.textContent="",s(0,null);return}let{camera:v}=n.eye,E=new G().setFromMatrixColumn(v.matrixWorld,0).multiplyScalar(_);E.addScaledVector(new G().setFromMatrixColumn(v.matrixWorld,1),b).setLength(Number(o.value)*i),a.textContent=`${r.selectedOptions[0].text} pushed with ${bt(E.length())} N`,s(Number(r.value),E.toArray())}function x(){d.size&&(d.clear(),p())}function g(_){d.has(_)||(d.add(_),p())}function m(_){d.clear(),d.add(_),p(),f=setTimeout(x,MT)}return l.addEventListener("keyup",({key:_})=>{d.delete(_)&&p()}),l.addEventListener("focusout",x),r.addEventListener("change",()=>{x(),h()}),u.addEventListener("toggle",h),u}function wT(n,e,t,i){let s="http://www.w3.org/2000/svg",r=document.createElementNS(s,"svg"),o=document.createElementNS(s,"circle");o.setAttribute("r","9"),r.classList.add("push"),r.setAttribute("aria-hidden","true"),r.append(o),n.element.append(r);let a=new G;function l(){if(r.style.display=i.open?"":"none",!i.open)return;let[c,u]=Io(a.fromArray(e.frame.points,3*t()),n.eye.camera,n.canvas);o.setAttribute("cx",c),o.setAttribute("cy",u)}return e.clock.onChange(l),n.eye.controls.addEventListener("change",l),l(),l}var AT=22;function Du(n,{points:e,movable:t,between:i=()=>null,moved:s,left:r}){let{canvas:o,eye:a}=n,l=document.createElementNS("http://www.w3.org/2000/svg","line"),c=document.createElementNS("http://www.w3.org/2000/svg","svg");c.classList.add("push"),c.setAttribute("aria-hidden","true"),c.append(l);let u=S("p",{className:"pushed","aria-hidden":"true"});n.element.append(c,u),c.style.display="none";let[h,d]=[new G,new G],f=null,p=null;function x(y){d.set(0,0,0);for(let[M,I]of y)d.addScaledVector(h.fromArray(e(),3*M),I);return d}function g(y){return Io(x(y),a.camera,o)}function m(y){let M=o.getBoundingClientRect();return[y.clientX-M.left,y.clientY-M.top]}function _([y,M]){let I={place:null,away:AT};for(let L=0;L<t.length;L++){if(!t[L])continue;let C=[[L,1]],[D,k]=g(C),N=Math.hypot(D-y,k-M);N<I.away&&(I={place:C,away:N})}return I.place}let b=([y,M])=>[2*y/o.clientWidth-1,1-2*M/o.clientHeight],v=y=>_(m(y))??i(...b(m(y)));function E(){if(!f)return;let y=g(f);for(let[M,I]of[["x1",y[0]],["y1",y[1]],["x2",p[0]],["y2",p[1]]])l.setAttribute(M,I);c.style.display=""}o.addEventListener("pointerdown",y=>{f=y.button===0?v(y):null,f&&(a.controls.enabled=!1,o.setPointerCapture(y.pointerId),y.stopImmediatePropagation())},{capture:!0}),o.addEventListener("pointermove",y=>{if(!f){o.classList.toggle("grip",v(y)!==null);return}p=m(y);let M=x(f).clone(),I=M.clone().project(a.camera).z;s(f,M,new G(...b(p),I).unproject(a.camera)),E()});let A=()=>{f&&(f=null,a.controls.enabled=!0,c.style.display="none",u.textContent="",r())};return o.addEventListener("pointerup",A),o.addEventListener("pointercancel",A),n.onDraw(E),{say:y=>u.textContent=y}}var ET=.25;function rx(n,e,t,i,s){let{say:r}=Du(n,{points:()=>e.frame.points,movable:e.movable,moved([[o]],a,l){let c=l.sub(a).multiplyScalar(i/(ET*t)).clampLength(0,i);s(o,c.toArray()),r(`pushed with ${bt(c.length())} N`)},left:()=>s(0,null)})}var nl=200,TT=20,CT=3;function ox(n,e,t){let i=n.map(o=>RT(o,e,t)),s=S("button",{type:"button",disabled:!0},`Reset all to ${e}`);s.addEventListener("click",()=>i.forEach(o=>o.reset()));let r=S("div",{className:"sliders",role:"group","aria-label":"values to change"});return r.append(...i.map(o=>o.element),s),{element:r,set(o){for(let a of i)a.put(o[a.knob.key]??a.knob.value)},get changes(){let o=i.filter(a=>a.value!==a.knob.value);return Object.fromEntries(o.map(a=>[a.knob.key,a.value]))},refresh(){s.disabled=i.every(o=>o.value===o.knob.value)}}}function RT(n,e,t){let{key:i,title:s,unit:r,factor:o,lowest:a,highest:l}=n,c=a>0&&l/a>=TT,u=E=>c?a*(l/a)**E:a+E*(l-a),h=E=>c?Math.log(E/a)/Math.log(l/a):(E-a)/(l-a),d=Math.round(nl*h(n.value)),f=Ot(i.replace("protocol.","").replace("youngs","Young's").replaceAll(/[._]/g," ")),p=S("input",{type:"range",min:0,max:nl,step:1,"aria-label":f,"aria-description":s}),x=S("output"),g=S("span",{className:"home",title:`in ${e}`,"aria-hidden":"true"});g.style.left=`${100*d/nl}%`,p.dataset.keys="own";let m=n.value;function _(){let E=`${bt(o*m)} ${r.replaceAll("^2","²").replaceAll("^3","³")}`;x.textContent=E,p.setAttribute("aria-valuetext",m===n.value?`${E}, as in ${e}`:E),v.classList.toggle("changed",m!==n.value)}function b(E){m=E,p.value=Math.round(nl*h(m)),_(),t(i,m)}p.addEventListener("input",()=>{let E=Number(p.value);m=E===d?n.value:Number((o*u(E/nl)).toPrecision(CT))/o,_(),t(i,m)});let v=S("label",{className:"slider",title:`${i}: ${s}`},S("span",{className:"name"},f),x,S("span",{className:"rail"},p,g));return p.value=d,_(),{element:v,knob:n,get value(){return m},put:b,reset:()=>b(n.value)}}var PT=[["real time",1],["1/2",.5],["1/5",.2],["1/20",.05],["1/100",.01]],IT=.2,Ou=1.4,LT="Values were changed, or it was pushed, during the motion, which no run of a design file repeats. “Whole protocol” runs these settings from the start.",NT=1e-15;async function Do(n,e,t,i,{look:s,pace:r=IT,set:o}={}){let a=JSON.parse(t),l={frame:null,engine:null,pace:r},c=await i(t,M=>A(M)),u=_0(n,a,c.first),h=S("p",{className:"verdict",role:"status"}),d=S("p",{className:"note"}),f=S("p",{className:"time"}),p=S("p",{className:"account"}),x=S("div"),g=S("div"),m=tx(a),_=ox(a.knobs,e.kind==="bench"?"the design":"this run",(M,I)=>{c.send({act:"set",values:{[M]:I}}),_.refresh(),m.refresh(_.changes),o?.(M,Q0(a,M,I))}),b=OT(a,c,l,()=>{h.textContent="",d.textContent=""}),v=a.motors.every(M=>M.kind==="torque")?"torques":"drives",E=null;function A(M){if(M.said==="refused"){h.textContent=`The simulator stopped: ${M.why}.`;return}M.said==="frame"&&y(M.frame)}function y(M){l.frame=M,u.show(M),f.textContent=`${qi(M.time_s,{start:0,end:Math.max(1,M.time_s)})}${UT(M,a.protocol)}`;let I=M.energies_J.reduce((N,B)=>N+B,0),L=M.works_J.reduce((N,B)=>N+B,0),C=[...n.tendons?[`tendon energy ${Ef(I)}`]:[],`work of the ${v} ${Ef(L)}`];p.textContent=C.join(" · ");let D=M.stageNumber===null?M.ended:null,k=D&&JSON.stringify([D.verdict,...D.stages.map(N=>N.end_s)]);k!==E&&(h.textContent=D?kT(D,e.whole,a.texts.outcome):"",d.textContent=[D?.advice,D&&M.meddled&&LT].filter(Boolean).join(" ")),E=k}return l.element=S("div",{className:"trial"},S("div",{className:"head"},S("div",{className:"choices"},...b),S("div",{className:"live-facts"},f,p),h,d),x,S("div",{className:"hands"},_.element,...o?[]:[m.element]),g),l.begin=()=>{let M=s??{...nr(),following:!1,closer:e.kind==="bench"?Ou:1},{stage:I}=Pu(x,[u.clip],u.clock,{...e,text:`${e.shape}, live.`},M);if(l.stage=I,or(g,u.clip,u.clock,e.energy),No(l.element),I){u.movable=a.anchors.bodies.map(D=>D>0);let L=DT(a,n.mesh.span_m),C=(D,k)=>c.send({act:"push",point:D,force:k});rx(I,u,n.mesh.span_m,L,C),x.querySelector(".picture").after(sx(I,u,a.anchors.names,L,C))}y(c.first),c.send({act:"pace",value:l.pace}),c.send({act:"restart",through:!1}),e.kind!=="bench"&&b[0].focus({preventScroll:!0})},l.leave=()=>l.stage?.dispose(),Object.assign(l,{engine:c,live:u,sliders:_,design:m,own:a})}function DT({protocol:n,motors:e},t){let i=n.drives.map(({strength:s,torques:r})=>{let o=e[r.findIndex(a=>a!==0)];return o?.kind==="torque"?Math.abs(s)/t:o?.kind==="force"?Math.abs(s):0});return Math.max(...i)||1}function OT({protocol:n},e,t,i){let s=(a,l,c)=>{let u=S("button",{type:"button",title:c});return u.append(a),u.addEventListener("click",()=>{i(),e.send(l)}),u},r=n.stages.flatMap(({name:a,drives:l},c)=>{if(!l.length)return[];let u=n.stages.findIndex((d,f)=>f>c&&d.drives.length>0),h=(u<0?n.stages.length:u)-1;return[s(Ot(a),{act:"stages",from:c,to:h},`the stage "${a}" of the protocol, and what follows without a drive`)]}),o=S("select",{},...PT.map(([a,l])=>S("option",{value:l,selected:l===t.pace},a)));return o.addEventListener("change",()=>{t.pace=Number(o.value),e.send({act:"pace",value:t.pace})}),[s("Start again",{act:"restart",through:!1},"from the start of the run"),...r,s("Release",{act:"release"},"without any drive"),s("Whole protocol",{act:"restart",through:!0},"all stages, as in the run"),S("label",{},"speed ",o)]}function UT({stage:n,stageNumber:e,running:t,ended:i},{stages:s}){let r=n&&!s[e].drives.length&&i?.stages.at(-1),a=r&&r.goal_s!==null&&s.find(({name:l})=>l===r.name).drives.length?`, ${r.name} reached its goal in ${ks(r.goal_s-r.start_s,"s")}`:"";return n?` · ${n}${a}`:t?" · no drive acts":" · at rest"}function kT({status:n,verdict:e,transitions:t},i,s){let r=t.filter(({took:o})=>o?.succeeded&&o.time_s!==null).map(({words:o,took:a})=>Lh(s.transition,{did:o.did||o.done,time:ks(a.time_s,"s"),work:Ef(a.work_J)}));return r.length?Lh(s[e==="reached"?"reached":"missed"],{whole:i,transitions:r.join(s.then),status:n}):`${Ot(n)}.`}var Ef=n=>ks(Math.abs(n)<NT?0:n,"J");function Uu(n,e,t,i,s=null){if(!n)return null;let r={panel:null,failed:"",start:null},o=document.getElementById("live").textContent,a=S("button",{type:"button",className:"try"},"Try it"),l=S("p",{className:"note"});l.textContent=`Move this ${t.whole} yourself: change values, switch drives, release it, push it. The simulator runs in this page.`,n.append(S("div",{className:"offer"},a,l));function c(h){r.failed=h,a.disabled=!0;let d="To drag its vertices, open the design in the workbench, with the command forficula open.",f=`A page cannot simulate the motion in time of this ${t.whole}: ${h}.`;if(l.textContent=`${s?`A slider folds this ${t.whole} along its quasi-static path. `:""}${d} ${f}`,!s)return;let p=S("button",{type:"button",className:"try"},"Fold it slowly");p.addEventListener("click",s),a.replaceWith(p)}let u=JSON.parse(o.startsWith('{"refused"')?o:"null");return u!==null?c(u.refused):xu()||c("this page was written without the engine"),r.start=async()=>{if(!a.disabled){a.disabled=!0,l.setAttribute("role","status"),l.textContent="Starting the simulator …",i();try{r.panel=await Do(e,t,o,Po),n.replaceChildren(S("h2",{},"Try it"),r.panel.element),r.panel.begin()}catch(h){c(h.message)}}},a.addEventListener("click",async()=>{await r.start(),r.failed||n.scrollIntoView({block:"start"})}),r}function ax(n){let e=Jn(n.clips[0]),t=Uu(document.getElementById("try"),e,n,()=>{});return t.start(),{clips:[e],trial:t}}var FT=200;function Oi(n,e){let t=new Set,i=e[0].start,s=e[0],r="even",o=!1,a=0,l=0,c=new Map;function u(){return c.has(s)||c.set(s,q0(n,s)),c.get(s)}let h=()=>r==="even"&&s.whole;function d(_){return h()?u().wayAt(_):(_-s.start)/(s.end-s.start||1)}function f(_){return h()?u().timeAt(_):s.start+_*(s.end-s.start)}function p(){l||(l=requestAnimationFrame(x))}function x(_){if(l=0,o){let b=Math.min((_-a)/1e3,.1);a=_,g(b),l=requestAnimationFrame(x)}for(let b of t)b()}function g(_){r==="even"?i=u().timeAt(Math.min(1,u().wayAt(i)+_/u().seconds)):i=Math.min(s.end,i+r*_),i>=s.end&&(o=!1)}function m(_){i=Math.min(s.end,Math.max(s.start,_)),p()}return{get time(){return i},get span(){return s},get speed(){return r},get playing(){return o},spans:e,clipTime:(_,b=i)=>Math.min(n[_].end,Math.max(n[_].start,b+s.origins[_])),get stretched(){return h()},shareAt:d,momentAt:f,wayAt:_=>u().wayAt(_),timeAt:_=>u().timeAt(_),get slowness(){if(r!=="even")return 1/r;let _=u().wayAt(i),[b,v]=[Math.max(0,_-5e-4),Math.min(1,_+5e-4)];return(v-b)*u().seconds/(u().timeAt(v)-u().timeAt(b)||1e-12)},onChange(_){return t.add(_),p(),()=>t.delete(_)},seek:m,seekClip(_,b){(b<s.start+s.origins[_]||b>s.end+s.origins[_])&&(s=e.find(v=>b>=v.start+v.origins[_]&&b<=v.end+v.origins[_])??e[0]),m(b-s.origins[_])},step:_=>m(f(d(i)+_/FT)),play(){i>=s.end&&(i=s.start),o=!0,a=performance.now(),p()},pause(){o=!1,p()},setSpeed(_){r=_,p()},setSpan(_){s=_,m(i<s.start||i>s.end?s.start:i)},redraw:p}}var BT="uplot",zT="u-hz",VT="u-vt",GT="u-title",HT="u-wrap",WT="u-under",$T="u-over",XT="u-axis",Nr="u-off",qT="u-select",YT="u-cursor-x",ZT="u-cursor-y",KT="u-cursor-pt",JT="u-legend",jT="u-live",QT="u-inline",eC="u-series",tC="u-marker",lx="u-label",nC="u-value",sl="width",rl="height";var cx="bottom",Oo="left",Tf="right",Wf="#000",ux=Wf+"0",Cf="mousemove",hx="mousedown",Rf="mouseup",dx="mouseenter",fx="mouseleave",px="dblclick",iC="resize",sC="scroll",mx="change",Vu="dppxchange",$f="--",Go=typeof window<"u",Df=Go?document:null,ko=Go?window:null,rC=Go?navigator:null,Et,ku;function Of(){let n=devicePixelRatio;Et!=n&&(Et=n,ku&&kf(mx,ku,Of),ku=matchMedia(`(min-resolution: ${Et-.001}dppx) and (max-resolution: ${Et+.001}dppx)`),Dr(mx,ku,Of),ko.dispatchEvent(new CustomEvent(Vu)))}function pi(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Uf(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Yt(n,e,t){n.style[e]=t+"px"}function Ui(n,e,t,i){let s=Df.createElement(n);return e!=null&&pi(s,e),t?.insertBefore(s,i),s}function Si(n,e){return Ui("div",n,e)}var gx=new WeakMap;function is(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=gx.get(n);r!=o&&(n.style.transform=r,gx.set(n,r),e<0||t<0||e>i||t>s?pi(n,Nr):Uf(n,Nr))}var xx=new WeakMap;function _x(n,e,t){let i=e+t,s=xx.get(n);i!=s&&(xx.set(n,i),n.style.background=e,n.style.borderColor=t)}var yx=new WeakMap;function vx(n,e,t,i){let s=e+""+t,r=yx.get(n);s!=r&&(yx.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var Xf={passive:!0},oC={...Xf,capture:!0};function Dr(n,e,t,i){e.addEventListener(n,t,i?oC:Xf)}function kf(n,e,t,i){e.removeEventListener(n,t,Xf)}Go&&Of();function ki(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:mi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function Yx(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var Zx=n=>n!=null,Kx=n=>n!=null&&n>0,Wu=Yx(Zx),aC=Yx(Kx);function lC(n,e,t,i=0,s=!1){let r=s?aC:Wu,o=s?Kx:Zx;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Bt,l??-Bt]}function $u(n,e,t,i){let s=Mx(n),r=Mx(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Ts:Jx,a=s==1?mi:Mi,l=r==1?Mi:mi,c=a(o(wn(n))),u=l(o(wn(e))),h=Fo(t,c),d=Fo(t,u);return t==10&&(c<0&&(h=zt(h,-c)),u<0&&(d=zt(d,-u))),i||t==2?(n=h*s,e=d*r):(n=t_(n,h),e=Xu(e,d)),[n,e]}function qf(n,e,t,i){let s=$u(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var Yf=.1,bx={mode:3,pad:Yf},al={pad:0,soft:null,mode:0},cC={min:al,max:al};function Gu(n,e,t,i){return qu(t)?Sx(n,e,t):(al.pad=t,al.soft=i?0:null,al.mode=i?3:0,Sx(n,e,cC))}function Mt(n,e){return n??e}function uC(n,e,t){for(e=Mt(e,0),t=Mt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function Sx(n,e,t){let i=t.min,s=t.max,r=Mt(i.pad,0),o=Mt(s.pad,0),a=Mt(i.hard,-Bt),l=Mt(s.hard,Bt),c=Mt(i.soft,Bt),u=Mt(s.soft,-Bt),h=Mt(i.mode,0),d=Mt(s.mode,0),f=e-n,p=Ts(f),x=jn(wn(n),wn(e)),g=Ts(x),m=wn(g-p);(f<1e-24||m>10)&&(f=0,(n==0||e==0)&&(f=1e-24,h==2&&c!=Bt&&(r=0),d==2&&u!=-Bt&&(o=0)));let _=f||x||1e3,b=Ts(_),v=Fo(10,mi(b)),E=_*(f==0?n==0?.1:1:r),A=zt(t_(n-E,v/10),24),y=n>=c&&(h==1||h==3&&A<=c||h==2&&A>=c)?c:Bt,M=jn(a,A<y&&n>=y?y:Fi(y,A)),I=_*(f==0?e==0?.1:1:o),L=zt(Xu(e+I,v/10),24),C=e<=u&&(d==1||d==3&&L>=u||d==2&&L<=u)?u:-Bt,D=Fi(l,L>C&&e<=C?C:jn(C,L));return M==D&&M==0&&(D=100),[M,D]}var hC=new Intl.NumberFormat(Go?rC.language:"en-US"),Zf=n=>hC.format(n),gi=Math,zu=gi.PI,wn=gi.abs,mi=gi.floor,Mn=gi.round,Mi=gi.ceil,Fi=gi.min,jn=gi.max,Fo=gi.pow,Mx=gi.sign,Ts=gi.log10,Jx=gi.log2,dC=(n,e=1)=>gi.sinh(n)*e,Pf=(n,e=1)=>gi.asinh(n/e),Bt=1/0;function wx(n){return(Ts((n^n>>31)-(n>>31))|0)+1}function Ff(n,e,t){return Fi(jn(n,e),t)}function jx(n){return typeof n=="function"}function yt(n){return jx(n)?n:()=>n}var fC=()=>{},Qx=n=>n,e_=(n,e)=>e,pC=n=>null,Ax=n=>!0,Ex=(n,e)=>n==e,mC=/\.\d*?(?=9{6,}|0{6,})/gm,Or=n=>{if(i_(n)||lr.has(n))return n;let e=`${n}`,t=e.match(mC);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Or(s)}e${r}`}return zt(n,i)};function Ir(n,e){return Or(zt(Or(n/e))*e)}function Xu(n,e){return Or(Mi(Or(n/e))*e)}function t_(n,e){return Or(mi(Or(n/e))*e)}function zt(n,e=0){if(i_(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Mn(i)/t}var lr=new Map;function n_(n){return((""+n).split(".")[1]||"").length}function cl(n,e,t,i){let s=[],r=i.map(n_);for(let o=e;o<t;o++){let a=wn(o),l=zt(Fo(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?u:zt(u,h);s.push(d),lr.set(d,h)}}return s}var ll={},Kf=[],Bo=[null,null],ar=Array.isArray,i_=Number.isInteger,gC=n=>n===void 0;function Tx(n){return typeof n=="string"}function qu(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function xC(n){return n!=null&&typeof n=="object"}var _C=Object.getPrototypeOf(Uint8Array),s_="__proto__";function zo(n,e=qu){let t;if(ar(n)){let i=n.find(s=>s!=null);if(ar(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=zo(n[s],e)}else t=n.slice()}else if(n instanceof _C)t=n.slice();else if(e(n)){t={};for(let i in n)i!=s_&&(t[i]=zo(n[i],e))}else t=n;return t}function gn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=s_&&(qu(n[s])?gn(n[s],zo(i[s])):n[s]=zo(i[s]))}return n}var yC=0,vC=1,bC=2;function SC(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function MC(n,e){if(EC(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return TC(o[0])||(o=AC(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=e?e[o][c]:vC,f=[];for(let p=0;p<u.length;p++){let x=u[p],g=r.get(l[p]);x===null?d!=yC&&(h[g]=x,d==bC&&f.push(g)):h[g]=x}SC(h,f,s),i.push(h)}}return i}var wC=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function AC(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function EC(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function TC(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=jn(1,mi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var r_=["January","February","March","April","May","June","July","August","September","October","November","December"],o_=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function a_(n){return n.slice(0,3)}var CC=o_.map(a_),RC=r_.map(a_),PC={MMMM:r_,MMM:RC,WWWW:o_,WWW:CC};function il(n){return(n<10?"0":"")+n}function IC(n){return(n<10?"00":n<100?"0":"")+n}var LC={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>il(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>il(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>il(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>il(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>il(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>IC(n.getMilliseconds())};function Jf(n,e){e=e||PC;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?LC[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var NC=new Intl.DateTimeFormat().resolvedOptions().timeZone;function DC(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==NC?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var l_=n=>n%1==0,Hu=[1,2,2.5,5],OC=cl(10,-32,0,Hu),c_=cl(10,0,32,Hu),UC=c_.filter(l_),Lr=OC.concat(c_),jf=`
`,u_="{YYYY}",Cx=jf+u_,h_="{M}/{D}",ol=jf+h_,Fu=ol+"/{YY}",d_="{aa}",kC="{h}:{mm}",Uo=kC+d_,Rx=jf+Uo,Px=":{ss}",Ct=null;function f_(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?cl(10,0,3,Hu).filter(l_):cl(10,-3,0,Hu)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,u_,Ct,Ct,Ct,Ct,Ct,Ct,1],[s*28,"{MMM}",Cx,Ct,Ct,Ct,Ct,Ct,1],[s,h_,Cx,Ct,Ct,Ct,Ct,Ct,1],[i,"{h}"+d_,Fu,Ct,ol,Ct,Ct,Ct,1],[t,Uo,Fu,Ct,ol,Ct,Ct,Ct,1],[e,Px,Fu+" "+Uo,Ct,ol+" "+Uo,Ct,Rx,Ct,1],[n,Px+".{fff}",Fu+" "+Uo,Ct,ol+" "+Uo,Ct,Rx,Ct,1]];function u(h){return(d,f,p,x,g,m)=>{let _=[],b=g>=o,v=g>=r&&g<o,E=h(p),A=zt(E*n,3),y=If(E.getFullYear(),b?0:E.getMonth(),v||b?1:E.getDate()),M=zt(y*n,3);if(v||b){let I=v?g/r:0,L=b?g/o:0,C=A==M?A:zt(If(y.getFullYear()+L,y.getMonth()+I,1)*n,3),D=new Date(Mn(C/n)),k=D.getFullYear(),N=D.getMonth();for(let B=0;C<=x;B++){let $=If(k+L*B,N+I*B,1),H=$-h(zt($*n,3));C=zt((+$+H)*n,3),C<=x&&_.push(C)}}else{let I=g>=s?s:g,L=mi(p)-mi(A),C=M+L+Xu(A-M,I);_.push(C);let D=h(C),k=D.getHours()+D.getMinutes()/t+D.getSeconds()/i,N=g/i,B=d.axes[f]._space,$=m/B;for(;C=zt(C+g,n==1?0:3),!(C>x);)if(N>1){let H=mi(zt(k+N,6))%24,Q=h(C).getHours()-H;Q>1&&(Q=-1),C-=Q*i,k=(k+N)%24;let ie=_[_.length-1];zt((C-ie)/g,3)*$>=.7&&_.push(C)}else _.push(C)}return _}}return[l,c,u]}var[FC,BC,zC]=f_(1),[VC,GC,HC]=f_(.001);cl(2,-53,53,[1]);function Ix(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function Lx(n,e){return(t,i,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,u,h,d,f;return i.map(p=>{let x=n(p),g=x.getFullYear(),m=x.getMonth(),_=x.getDate(),b=x.getHours(),v=x.getMinutes(),E=x.getSeconds(),A=g!=l&&a[2]||m!=c&&a[3]||_!=u&&a[4]||b!=h&&a[5]||v!=d&&a[6]||E!=f&&a[7]||a[1];return l=g,c=m,u=_,h=b,d=v,f=E,A(x)})}}function WC(n,e){let t=Jf(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function If(n,e,t){return new Date(n,e,t)}function Nx(n,e){return e(n)}var $C="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Dx(n,e){return(t,i,s,r)=>r==null?$f:e(n(i))}function XC(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function qC(n,e){return n.series[e].fill(n,e)}var YC={show:!0,live:!0,isolate:!1,mount:fC,markers:{show:!0,width:2,stroke:XC,fill:qC,dash:"solid"},idx:null,idxs:null,values:[]};function ZC(n,e){let t=n.cursor.points,i=Si(),s=t.size(n,e);Yt(i,sl,s),Yt(i,rl,s);let r=s/-2;Yt(i,"marginLeft",r),Yt(i,"marginTop",r);let o=t.width(n,e,s);return o&&Yt(i,"borderWidth",o),i}function KC(n,e){let t=n.series[e].points;return t._fill||t._stroke}function JC(n,e){let t=n.series[e].points;return t._stroke||t._fill}function jC(n,e){return n.series[e].points.size}var Lf=[0,0];function QC(n,e,t){return Lf[0]=e,Lf[1]=t,Lf}function Bu(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function Nf(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var eR={show:!0,x:!0,y:!0,lock:!1,move:QC,points:{one:!1,show:ZC,size:jC,width:0,stroke:JC,fill:KC},bind:{mousedown:Bu,mouseup:Bu,click:Bu,dblclick:Bu,mousemove:Nf,mouseleave:Nf,mouseenter:Nf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},p_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Qf=gn({},p_,{filter:e_}),m_=gn({},Qf,{size:10}),g_=gn({},p_,{show:!1}),ep='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',x_="bold "+ep,__=1.5,Ox={show:!0,scale:"x",stroke:Wf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:x_,side:2,grid:Qf,ticks:m_,border:g_,font:ep,lineGap:__,rotate:0},tR="Value",nR="Time",Ux={show:!0,scale:"x",auto:!1,sorted:1,min:Bt,max:-Bt,idxs:[]};function iR(n,e,t,i,s){return e.map(r=>r==null?"":Zf(r))}function sR(n,e,t,i,s,r,o){let a=[],l=lr.get(s)||0;t=o?t:zt(Xu(t,s),l);for(let c=t;c<=i;c=zt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Bf(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Ts:Jx,u=mi(c(t));s=Fo(l,u),l==10&&(s=Lr[ki(s,Lr)]);let h=t,d=s*l;l==10&&(d=Lr[ki(d,Lr)]);do a.push(h),h=h+s,l==10&&!lr.has(h)&&(h=zt(h,lr.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=Lr[ki(d,Lr)]));while(h<=i);return a}function rR(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Bf(n,e,jn(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?Bf(n,e,jn(l,-i),-t,s):[l]).reverse().map(d=>-d).concat(u,c)}var y_=/./,oR=/[12357]/,aR=/[125]/,kx=/1/,zf=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function lR(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?y_:l(7,o)-u>=c?oR:l(5,o)-u>=c?aR:kx;if(h==kx){let d=wn(l(1,o)-u);if(d<c)return zf(e.slice().reverse(),a.distr,h,Mi(c/d)).reverse()}return zf(e,a.distr,h,1)}function cR(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=wn(l(1,o)-l(2,o));return c<a?zf(e.slice().reverse(),3,y_,Mi(a/c)).reverse():e}function uR(n,e,t,i){return i==null?$f:e==null?"":Zf(e)}var Fx={show:!0,scale:"y",stroke:Wf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:x_,side:3,grid:Qf,ticks:m_,border:g_,font:ep,lineGap:__,rotate:0};function hR(n,e){let t=3+(n||1)*2;return zt(t*e,3)}function dR(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=wn(o-r),l=n.series[e],c=a/(l.points.space*Et);return i[1]-i[0]<=c}var Bx={scale:null,auto:!0,sorted:0,min:Bt,max:-Bt},v_=(n,e,t,i,s)=>s,zx={show:!0,auto:!0,sorted:0,gaps:v_,alpha:1,facets:[gn({},Bx,{scale:"x"}),gn({},Bx,{scale:"y"})]},Vx={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:v_,alpha:1,points:{show:dR,filter:null},values:null,min:Bt,max:-Bt,idxs:[],path:null,clip:null};function fR(n,e,t,i,s){return t/10}var b_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},pR=gn({},b_,{time:!1,ori:1}),Gx={};function S_(n,e){let t=Gx[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(Gx[n]=t)),t}var Vo=1,Vf=2;function Ur(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,x=a.height,g=n.valToPosH,m=n.valToPosV;return u.ori==0?t(s,l,c,u,h,g,m,d,f,p,x,Zu,Ho,Ju,w_,E_):t(s,l,c,u,h,m,g,f,d,x,p,Ku,Wo,ip,A_,T_)}function tp(n,e){let t=0,i=0,s=Mt(n.bands,Kf);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function mR(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Cs(n,e,t,i,s,r){return Ur(n,e,(o,a,l,c,u,h,d,f,p,x,g)=>{let m=o.pxRound,_=c.dir*(c.ori==0?1:-1),b=c.ori==0?Ho:Wo,v,E;_==1?(v=t,E=i):(v=i,E=t);let A=m(h(a[v],c,x,f)),y=m(d(l[v],u,g,p)),M=m(h(a[E],c,x,f)),I=m(d(r==1?u.max:u.min,u,g,p)),L=new Path2D(s);return b(L,M,I),b(L,A,I),b(L,A,y),L})}function Yu(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?Ju:ip,l=t;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function gR(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function np(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let h=c,d=c;if(s==1)for(;++c<=i&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(n[h]),p=d==h?f:r(n[d]),x=h-s;f=o<=0&&x>=0&&x<l?r(n[x]):f;let m=d+s;p=o>=0&&m>=0&&m<l?r(n[m]):p,p>=f&&a.push([f,p])}return a}function Hx(n){return n==0?Qx:n==1?Mn:e=>Ir(e,n)}function M_(n){let e=n==0?Zu:Ku,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Fi(c,a/2,l/2),u=Fi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Zu=(n,e,t)=>{n.moveTo(e,t)},Ku=(n,e,t)=>{n.moveTo(t,e)},Ho=(n,e,t)=>{n.lineTo(e,t)},Wo=(n,e,t)=>{n.lineTo(t,e)},Ju=M_(0),ip=M_(1),w_=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},A_=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},E_=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},T_=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function C_(n){return(e,t,i,s,r)=>Ur(e,t,(o,a,l,c,u,h,d,f,p,x,g)=>{let{pxRound:m,points:_}=o,b,v;c.ori==0?(b=Zu,v=w_):(b=Ku,v=A_);let E=zt(_.width*Et,3),A=(_.size-_.width)/2*Et,y=zt(A*2,3),M=new Path2D,I=new Path2D,{left:L,top:C,width:D,height:k}=e.bbox;Ju(I,L-y,C-y,D+y*2,k+y*2);let N=B=>{if(l[B]!=null){let $=m(h(a[B],c,x,f)),H=m(d(l[B],u,g,p));b(M,$+A,H),v(M,$,H,A,0,zu*2)}};if(r)r.forEach(N);else for(let B=i;B<=s;B++)N(B);return{stroke:E>0?M:null,fill:M,clip:I,flags:Vo|Vf}})}function R_(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var xR=R_(Ho),_R=R_(Wo);function P_(n){let e=Mt(n?.alignGaps,0);return(t,i,s,r)=>Ur(t,i,(o,a,l,c,u,h,d,f,p,x,g)=>{[s,r]=Wu(l,s,r);let m=o.pxRound,_=k=>m(h(k,c,x,f)),b=k=>m(d(k,u,g,p)),v,E;c.ori==0?(v=Ho,E=xR):(v=Wo,E=_R);let A=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Vo},M=y.stroke,I=!1;if(r-s>=x*4){let k=de=>t.posToVal(de,c.key,!0),N=null,B=null,$,H,se,Y=_(a[A==1?s:r]),Q=_(a[s]),ie=_(a[r]),fe=k(A==1?Q+1:ie-1);for(let de=A==1?s:r;de>=s&&de<=r;de+=A){let ee=a[de],ge=(A==1?ee<fe:ee>fe)?Y:_(ee),Se=l[de];ge==Y?Se!=null?(H=Se,N==null?(v(M,ge,b(H)),$=N=B=H):H<N?N=H:H>B&&(B=H)):Se===null&&(I=!0):(N!=null&&E(M,Y,b(N),b(B),b($),b(H)),Se!=null?(H=Se,v(M,ge,b(H)),N=B=$=H):(N=B=null,Se===null&&(I=!0)),Y=ge,fe=k(Y+A))}N!=null&&N!=B&&se!=Y&&E(M,Y,b(N),b(B),b($),b(H))}else for(let k=A==1?s:r;k>=s&&k<=r;k+=A){let N=l[k];N===null?I=!0:N!=null&&v(M,_(a[k]),b(N))}let[C,D]=tp(t,i);if(o.fill!=null||C!=0){let k=y.fill=new Path2D(M),N=o.fillTo(t,i,o.min,o.max,C),B=b(N),$=_(a[s]),H=_(a[r]);A==-1&&([H,$]=[$,H]),v(k,H,B),v(k,$,B)}if(!o.spanGaps){let k=[];I&&k.push(...np(a,l,s,r,A,_,e)),y.gaps=k=o.gaps(t,i,s,r,k),y.clip=Yu(k,c.ori,f,p,x,g)}return D!=0&&(y.band=D==2?[Cs(t,i,s,r,M,-1),Cs(t,i,s,r,M,1)]:Cs(t,i,s,r,M,D)),y})}function yR(n){let e=Mt(n.align,1),t=Mt(n.ascDesc,!1),i=Mt(n.alignGaps,0),s=Mt(n.extend,!1);return(r,o,a,l)=>Ur(r,o,(c,u,h,d,f,p,x,g,m,_,b)=>{[a,l]=Wu(h,a,l);let v=c.pxRound,{left:E,width:A}=r.bbox,y=Q=>v(p(Q,d,_,g)),M=Q=>v(x(Q,f,b,m)),I=d.ori==0?Ho:Wo,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Vo},C=L.stroke,D=d.dir*(d.ori==0?1:-1),k=M(h[D==1?a:l]),N=y(u[D==1?a:l]),B=N,$=N;s&&e==-1&&($=E,I(C,$,k)),I(C,N,k);for(let Q=D==1?a:l;Q>=a&&Q<=l;Q+=D){let ie=h[Q];if(ie==null)continue;let fe=y(u[Q]),de=M(ie);e==1?I(C,fe,k):I(C,B,de),I(C,fe,de),k=de,B=fe}let H=B;s&&e==1&&(H=E+A,I(C,H,k));let[se,Y]=tp(r,o);if(c.fill!=null||se!=0){let Q=L.fill=new Path2D(C),ie=c.fillTo(r,o,c.min,c.max,se),fe=M(ie);I(Q,H,fe),I(Q,$,fe)}if(!c.spanGaps){let Q=[];Q.push(...np(u,h,a,l,D,y,i));let ie=c.width*Et/2,fe=t||e==1?ie:-ie,de=t||e==-1?-ie:ie;Q.forEach(ee=>{ee[0]+=fe,ee[1]+=de}),L.gaps=Q=c.gaps(r,o,a,l,Q),L.clip=Yu(Q,d.ori,g,m,_,b)}return Y!=0&&(L.band=Y==2?[Cs(r,o,a,l,C,-1),Cs(r,o,a,l,C,1)]:Cs(r,o,a,l,C,Y)),L})}function Wx(n,e,t,i,s,r,o=Bt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=wn(n[l]-n[a]);u<c&&(c=u,o=wn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function vR(n){n=n||ll;let e=Mt(n.size,[.6,Bt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=yt(s),o=1-e[0],a=Mt(e[1],Bt),l=Mt(e[2],1),c=Mt(n.disp,ll),u=Mt(n.each,f=>{}),{fill:h,stroke:d}=c;return(f,p,x,g)=>Ur(f,p,(m,_,b,v,E,A,y,M,I,L,C)=>{let D=m.pxRound,k=t,N=i*Et,B=a*Et,$=l*Et,H,se;v.ori==0?[H,se]=r(f,p):[se,H]=r(f,p);let Y=v.dir*(v.ori==0?1:-1),Q=v.ori==0?Ju:ip,ie=v.ori==0?u:(Re,Ze,rt,we,kt,ze,Xe)=>{u(Re,Ze,rt,kt,we,Xe,ze)},fe=Mt(f.bands,Kf).find(Re=>Re.series[0]==p),de=fe!=null?fe.dir:0,ee=m.fillTo(f,p,m.min,m.max,de),he=D(y(ee,E,C,I)),ge,Se,Me,He=L,st=D(m.width*Et),Ve=!1,ht=null,lt=null,nt=null,Zt=null;h!=null&&(st==0||d!=null)&&(Ve=!0,ht=h.values(f,p,x,g),lt=new Map,new Set(ht).forEach(Re=>{Re!=null&&lt.set(Re,new Path2D)}),st>0&&(nt=d.values(f,p,x,g),Zt=new Map,new Set(nt).forEach(Re=>{Re!=null&&Zt.set(Re,new Path2D)})));let{x0:Vt,size:cn}=c;if(Vt!=null&&cn!=null){k=1,_=Vt.values(f,p,x,g),Vt.unit==2&&(_=_.map(rt=>f.posToVal(M+rt*L,v.key,!0)));let Re=cn.values(f,p,x,g);cn.unit==2?Se=Re[0]*L:Se=A(Re[0],v,L,M)-A(0,v,L,M),He=Wx(_,b,A,v,L,M,He),Me=He-Se+N}else He=Wx(_,b,A,v,L,M,He),Me=He*o+N,Se=He-Me;Me<1&&(Me=0),st>=Se/2&&(st=0),Me<5&&(D=Qx);let Nt=Me>0,An=He-Me-(Nt?st:0);Se=D(Ff(An,$,B)),ge=(k==0?Se/2:k==Y?0:Se)-k*Y*((k==0?N/2:0)+(Nt?st/2:0));let vt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},xn=Ve?null:new Path2D,jt=null;if(fe!=null)jt=f.data[fe.series[1]];else{let{y0:Re,y1:Ze}=c;Re!=null&&Ze!=null&&(b=Ze.values(f,p,x,g),jt=Re.values(f,p,x,g))}let un=H*Se,V=se*Se;for(let Re=Y==1?x:g;Re>=x&&Re<=g;Re+=Y){let Ze=b[Re];if(Ze==null)continue;if(jt!=null){let q=jt[Re]??0;if(Ze-q==0)continue;he=y(q,E,C,I)}let rt=v.distr!=2||c!=null?_[Re]:Re,we=A(rt,v,L,M),kt=y(Mt(Ze,ee),E,C,I),ze=D(we-ge),Xe=D(jn(kt,he)),O=D(Fi(kt,he)),T=Xe-O;if(Ze!=null){let q=Ze<0?V:un,ue=Ze<0?un:V;Ve?(st>0&&nt[Re]!=null&&Q(Zt.get(nt[Re]),ze,O+mi(st/2),Se,jn(0,T-st),q,ue),ht[Re]!=null&&Q(lt.get(ht[Re]),ze,O+mi(st/2),Se,jn(0,T-st),q,ue)):Q(xn,ze,O+mi(st/2),Se,jn(0,T-st),q,ue),ie(f,p,Re,ze-st/2,O,Se+st,T)}}return st>0?vt.stroke=Ve?Zt:xn:Ve||(vt._fill=m.width==0?m._fill:m._stroke??m._fill,vt.width=0),vt.fill=Ve?lt:xn,vt})}function bR(n,e){let t=Mt(e?.alignGaps,0);return(i,s,r,o)=>Ur(i,s,(a,l,c,u,h,d,f,p,x,g,m)=>{[r,o]=Wu(c,r,o);let _=a.pxRound,b=H=>_(d(H,u,g,p)),v=H=>_(f(H,h,m,x)),E,A,y;u.ori==0?(E=Zu,y=Ho,A=E_):(E=Ku,y=Wo,A=T_);let M=u.dir*(u.ori==0?1:-1),I=b(l[M==1?r:o]),L=I,C=[],D=[];for(let H=M==1?r:o;H>=r&&H<=o;H+=M)if(c[H]!=null){let Y=l[H],Q=b(Y);C.push(L=Q),D.push(v(c[H]))}let k={stroke:n(C,D,E,y,A,_),fill:null,clip:null,band:null,gaps:null,flags:Vo},N=k.stroke,[B,$]=tp(i,s);if(a.fill!=null||B!=0){let H=k.fill=new Path2D(N),se=a.fillTo(i,s,a.min,a.max,B),Y=v(se);y(H,L,Y),y(H,I,Y)}if(!a.spanGaps){let H=[];H.push(...np(l,c,r,o,M,b,t)),k.gaps=H=a.gaps(i,s,r,o,H),k.clip=Yu(H,u.ori,p,x,g,m)}return $!=0&&(k.band=$==2?[Cs(i,s,r,o,N,-1),Cs(i,s,r,o,N,1)]:Cs(i,s,r,o,N,$)),k})}function SR(n){return bR(MR,n)}function MR(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=e[d+1]-e[d],h[d]=n[d+1]-n[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+h[d]/3,e[d]+l[d]*h[d]/3,n[d+1]-h[d]/3,e[d+1]-l[d+1]*h[d]/3,n[d+1],e[d+1])}return a}var Gf=new Set;function $x(){for(let n of Gf)n.syncRect(!0)}Go&&(Dr(iC,ko,$x),Dr(sC,ko,$x,!0),Dr(Vu,ko,()=>{ln.pxRatio=Et}));var wR=P_(),AR=C_();function Xx(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Hf(r,o,e,t))}function ER(n,e){return n.map((t,i)=>i==0?{}:gn({},e,t))}function Hf(n,e,t,i){return gn({},e==0?t:i,n)}function I_(n,e,t){return e==null?Bo:[e,t]}var TR=I_;function CR(n,e,t){return e==null?Bo:Gu(e,t,Yf,!0)}function L_(n,e,t,i){return e==null?Bo:$u(e,t,n.scales[i].log,!1)}var RR=L_;function N_(n,e,t,i){return e==null?Bo:qf(e,t,n.scales[i].log,!1)}var PR=N_;function IR(n,e,t,i,s){let r=jn(wx(n),wx(e)),o=e-n,a=ki(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?lr.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function qx(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Mn((t=+s)*Et))+"px"),[n,e,t]}function LR(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=zt(e[2]*Et,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function ln(n,e,t){let i={mode:Mt(n.mode,1)},s=i.mode;function r(w,R,U,F){let X=R.valToPct(w);return F+U*(R.dir==-1?1-X:X)}function o(w,R,U,F){let X=R.valToPct(w);return F+U*(R.dir==-1?X:1-X)}function a(w,R,U,F){return R.ori==0?r(w,R,U,F):o(w,R,U,F)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Si(BT);if(n.id!=null&&(c.id=n.id),pi(c,n.class),n.title){let w=Si(GT,c);w.textContent=n.title}let u=Ui("canvas"),h=i.ctx=u.getContext("2d"),d=Si(HT,c);Dr("click",d,w=>{w.target===p&&(Ht!=Hr||Kt!=Wr)&&Ln.click(i,w)},!0);let f=i.under=Si(WT,d);d.appendChild(u);let p=i.over=Si($T,d);n=zo(n);let x=+Mt(n.pxAlign,1),g=Hx(x);(n.plugins||[]).forEach(w=>{w.opts&&(n=w.opts(i,n)||n)});let m=n.ms||.001,_=i.series=s==1?Xx(n.series||[],Ux,Vx,!1):ER(n.series||[null],zx),b=i.axes=Xx(n.axes||[],Ox,Fx,!0),v=i.scales={},E=i.bands=n.bands||[];E.forEach(w=>{w.fill=yt(w.fill||null),w.dir=Mt(w.dir,-1)});let A=s==2?_[1].facets[0].scale:_[0].scale,y={axes:ls,series:ft},M=(n.drawOrder||["axes","series"]).map(w=>y[w]);function I(w){let R=w.distr==3?U=>Ts(U>0?U:w.clamp(i,U,w.min,w.max,w.key)):w.distr==4?U=>Pf(U,w.asinh):w.distr==100?U=>w.fwd(U):U=>U;return U=>{let F=R(U),{_min:X,_max:J}=w,le=J-X;return(F-X)/le}}function L(w){let R=v[w];if(R==null){let U=(n.scales||ll)[w]||ll;if(U.from!=null){L(U.from);let F=gn({},v[U.from],U,{key:w});F.valToPct=I(F),v[w]=F}else{R=v[w]=gn({},w==A?b_:pR,U),R.key=w;let F=R.time,X=R.range,J=ar(X);if((w!=A||s==2&&!F)&&(J&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?bx:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?bx:{mode:1,hard:X[1],soft:X[1]}},J=!1),!J&&qu(X))){let le=X;X=(pe,ve,Ne)=>ve==null?Bo:Gu(ve,Ne,le)}R.range=yt(X||(F?TR:w==A?R.distr==3?RR:R.distr==4?PR:I_:R.distr==3?L_:R.distr==4?N_:CR)),R.auto=yt(J?!1:R.auto),R.clamp=yt(R.clamp||fR),R._min=R._max=null,R.valToPct=I(R)}}}L("x"),L("y"),s==1&&_.forEach(w=>{L(w.scale)}),b.forEach(w=>{L(w.scale)});for(let w in n.scales)L(w);let C=v[A],D=C.distr,k,N;C.ori==0?(pi(c,zT),k=r,N=o):(pi(c,VT),k=o,N=r);let B={};for(let w in v){let R=v[w];(R.min!=null||R.max!=null)&&(B[w]={min:R.min,max:R.max},R.min=R.max=null)}let $=n.tzDate||(w=>new Date(Mn(w/m))),H=n.fmtDate||Jf,se=m==1?zC($):HC($),Y=Lx($,Ix(m==1?BC:GC,H)),Q=Dx($,Nx($C,H)),ie=[],fe=i.legend=gn({},YC,n.legend),de=i.cursor=gn({},eR,{drag:{y:s==2}},n.cursor),ee=fe.show,he=de.show,ge=fe.markers;fe.idxs=ie,ge.width=yt(ge.width),ge.dash=yt(ge.dash),ge.stroke=yt(ge.stroke),ge.fill=yt(ge.fill);let Se,Me,He,st=[],Ve=[],ht,lt=!1,nt={};if(fe.live){let w=_[1]?_[1].values:null;lt=w!=null,ht=lt?w(i,1,0):{_:0};for(let R in ht)nt[R]=$f}if(ee)if(Se=Ui("table",JT,c),He=Ui("tbody",null,Se),fe.mount(i,Se),lt){Me=Ui("thead",null,Se,He);let w=Ui("tr",null,Me);Ui("th",null,w);for(var Zt in ht)Ui("th",lx,w).textContent=Zt}else pi(Se,QT),fe.live&&pi(Se,jT);let Vt={show:!0},cn={show:!1};function Nt(w,R){if(R==0&&(lt||!fe.live||s==2))return Bo;let U=[],F=Ui("tr",eC,He,He.childNodes[R]);pi(F,w.class),w.show||pi(F,Nr);let X=Ui("th",null,F);if(ge.show){let pe=Si(tC,X);if(R>0){let ve=ge.width(i,R);ve&&(pe.style.border=ve+"px "+ge.dash(i,R)+" "+ge.stroke(i,R)),pe.style.background=ge.fill(i,R)}}let J=Si(lx,X);w.label instanceof HTMLElement?J.appendChild(w.label):J.textContent=w.label,R>0&&(ge.show||(J.style.color=w.width>0?ge.stroke(i,R):ge.fill(i,R)),vt("click",X,pe=>{if(de._lock)return;Je(pe);let ve=_.indexOf(w);if((pe.ctrlKey||pe.metaKey)!=fe.isolate){let Ne=_.some((De,Ue)=>Ue>0&&Ue!=ve&&De.show);_.forEach((De,Ue)=>{Ue>0&&Gi(Ue,Ne?Ue==ve?Vt:cn:Vt,!0,pn.setSeries)})}else Gi(ve,{show:!w.show},!0,pn.setSeries)},!1),je&&vt(dx,X,pe=>{de._lock||(Je(pe),Gi(_.indexOf(w),Xr,!0,pn.setSeries))},!1));for(var le in ht){let pe=Ui("td",nC,F);pe.textContent="--",U.push(pe)}return[F,U]}let An=new Map;function vt(w,R,U,F=!0){let X=An.get(R)||{},J=de.bind[w](i,R,U,F);J&&(Dr(w,R,X[w]=J),An.set(R,X))}function xn(w,R,U){let F=An.get(R)||{};for(let X in F)(w==null||X==w)&&(kf(X,R,F[X]),delete F[X]);w==null&&An.delete(R)}let jt=0,un=0,V=0,Re=0,Ze=0,rt=0,we=Ze,kt=rt,ze=V,Xe=Re,O=0,T=0,q=0,ue=0;i.bbox={};let ae=!1,_e=!1,ye=!1,te=!1,re=!1,me=!1;function z(w,R,U){(U||w!=i.width||R!=i.height)&&oe(w,R),ct(!1),ye=!0,_e=!0,Un()}function oe(w,R){i.width=jt=V=w,i.height=un=Re=R,Ze=rt=0,be(),Ge();let U=i.bbox;O=U.left=Ir(Ze*Et,.5),T=U.top=Ir(rt*Et,.5),q=U.width=Ir(V*Et,.5),ue=U.height=Ir(Re*Et,.5)}let ne=3;function Ae(){let w=!1,R=0;for(;!w;){R++;let U=zr(R),F=Vi(R);w=R==ne||U&&F,w||(oe(i.width,i.height),_e=!0)}}function xe({width:w,height:R}){z(w,R)}i.setSize=xe;function be(){let w=!1,R=!1,U=!1,F=!1;b.forEach((X,J)=>{if(X.show&&X._show){let{side:le,_size:pe}=X,ve=le%2,Ne=X.label!=null?X.labelSize:0,De=pe+Ne;De>0&&(ve?(V-=De,le==3?(Ze+=De,F=!0):U=!0):(Re-=De,le==0?(rt+=De,w=!0):R=!0))}}),Bi[0]=w,Bi[1]=U,Bi[2]=R,Bi[3]=F,V-=wi[1]+wi[3],Ze+=wi[3],Re-=wi[2]+wi[0],rt+=wi[0]}function Ge(){let w=Ze+V,R=rt+Re,U=Ze,F=rt;function X(J,le){switch(J){case 1:return w+=le,w-le;case 2:return R+=le,R-le;case 3:return U-=le,U+le;case 0:return F-=le,F+le}}b.forEach((J,le)=>{if(J.show&&J._show){let pe=J.side;J._pos=X(pe,J._size),J.label!=null&&(J._lpos=X(pe,J.labelSize))}})}if(de.dataIdx==null){let w=de.hover,R=w.skip=new Set(w.skip??[]);R.add(void 0);let U=w.prox=yt(w.prox),F=w.bias??=0;de.dataIdx=(X,J,le,pe)=>{if(J==0)return le;let ve=le,Ne=U(X,J,le,pe)??Bt,De=Ne>=0&&Ne<Bt,Ue=C.ori==0?V:Re,it=de.left,wt=e[0],St=e[J];if(R.has(St[le])){ve=null;let mt=null,Ke=null,We;if(F==0||F==-1)for(We=le;mt==null&&We-- >0;)R.has(St[We])||(mt=We);if(F==0||F==1)for(We=le;Ke==null&&We++<St.length;)R.has(St[We])||(Ke=We);if(mt!=null||Ke!=null)if(De){let $t=mt==null?-1/0:k(wt[mt],C,Ue,0),tn=Ke==null?1/0:k(wt[Ke],C,Ue,0),Rn=it-$t,Dt=tn-it;Rn<=Dt?Rn<=Ne&&(ve=mt):Dt<=Ne&&(ve=Ke)}else ve=Ke==null?mt:mt==null?Ke:le-mt<=Ke-le?mt:Ke}else De&&wn(it-k(wt[le],C,Ue,0))>Ne&&(ve=null);return ve}}let Je=w=>{de.event=w};de.idxs=ie,de._lock=!1;let ce=de.points;ce.show=yt(ce.show),ce.size=yt(ce.size),ce.stroke=yt(ce.stroke),ce.width=yt(ce.width),ce.fill=yt(ce.fill);let ke=i.focus=gn({},n.focus||{alpha:.3},de.focus),je=ke.prox>=0,Ce=je&&ce.one,ot=[],Gt=[],Gn=[];function Yo(w,R){let U=ce.show(i,R);if(U instanceof HTMLElement)return pi(U,KT),pi(U,w.class),is(U,-10,-10,V,Re),p.insertBefore(U,ot[R]),U}function kr(w,R){if(s==1||R>0){let U=s==1&&v[w.scale].time,F=w.value;w.value=U?Tx(F)?Dx($,Nx(F,H)):F||Q:F||uR,w.label=w.label||(U?nR:tR)}if(Ce||R>0){w.width=w.width==null?1:w.width,w.paths=w.paths||wR||pC,w.fillTo=yt(w.fillTo||mR),w.pxAlign=+Mt(w.pxAlign,x),w.pxRound=Hx(w.pxAlign),w.stroke=yt(w.stroke||null),w.fill=yt(w.fill||null),w._stroke=w._fill=w._paths=w._focus=null;let U=hR(jn(1,w.width),1),F=w.points=gn({},{size:U,width:jn(1,U*.2),stroke:w.stroke,space:U*2,paths:AR,_stroke:null,_fill:null},w.points);F.show=yt(F.show),F.filter=yt(F.filter),F.fill=yt(F.fill),F.stroke=yt(F.stroke),F.paths=yt(F.paths),F.pxAlign=w.pxAlign}if(ee){let U=Nt(w,R);st.splice(R,0,U[0]),Ve.splice(R,0,U[1]),fe.values.push(null)}if(he){ie.splice(R,0,null);let U=null;Ce?R==0&&(U=Yo(w,R)):R>0&&(U=Yo(w,R)),ot.splice(R,0,U),Gt.splice(R,0,0),Gn.splice(R,0,0)}Cn("addSeries",R)}function bh(w,R){R=R??_.length,w=s==1?Hf(w,R,Ux,Vx):Hf(w,R,{},zx),_.splice(R,0,w),kr(_[R],R)}i.addSeries=bh;function hl(w){if(_.splice(w,1),ee){fe.values.splice(w,1),Ve.splice(w,1);let R=st.splice(w,1)[0];xn(null,R.firstChild),R.remove()}he&&(ie.splice(w,1),ot.splice(w,1)[0].remove(),Gt.splice(w,1),Gn.splice(w,1)),Cn("delSeries",w)}i.delSeries=hl;let Bi=[!1,!1,!1,!1];function rs(w,R){if(w._show=w.show,w.show){let U=w.side%2,F=v[w.scale];F==null&&(w.scale=U?_[1].scale:A,F=v[w.scale]);let X=F.time;w.size=yt(w.size),w.space=yt(w.space),w.rotate=yt(w.rotate),ar(w.incrs)&&w.incrs.forEach(le=>{!lr.has(le)&&lr.set(le,n_(le))}),w.incrs=yt(w.incrs||(F.distr==2?UC:X?m==1?FC:VC:Lr)),w.splits=yt(w.splits||(X&&F.distr==1?se:F.distr==3?Bf:F.distr==4?rR:sR)),w.stroke=yt(w.stroke),w.grid.stroke=yt(w.grid.stroke),w.ticks.stroke=yt(w.ticks.stroke),w.border.stroke=yt(w.border.stroke);let J=w.values;w.values=ar(J)&&!ar(J[0])?yt(J):X?ar(J)?Lx($,Ix(J,H)):Tx(J)?WC($,J):J||Y:J||iR,w.filter=yt(w.filter||(F.distr>=3&&F.log==10?lR:F.distr==3&&F.log==2?cR:e_)),w.font=qx(w.font),w.labelFont=qx(w.labelFont),w._size=w.size(i,null,R,0),w._space=w._rotate=w._incrs=w._found=w._splits=w._values=null,w._size>0&&(Bi[R]=!0,w._el=Si(XT,d))}}function os(w,R,U,F){let[X,J,le,pe]=U,ve=R%2,Ne=0;return ve==0&&(pe||J)&&(Ne=R==0&&!X||R==2&&!le?Mn(Ox.size/3):0),ve==1&&(X||le)&&(Ne=R==1&&!J||R==3&&!pe?Mn(Fx.size/2):0),Ne}let Zo=i.padding=(n.padding||[os,os,os,os]).map(w=>yt(Mt(w,os))),wi=i._padding=Zo.map((w,R)=>w(i,R,Bi,0)),Qt,rn=null,on=null,zi=s==1?_[0].idxs:null,ni=null,Is=!1;function Ko(w,R){if(e=w??[],i.data=i._data=e,s==2){Qt=0;for(let U=1;U<_.length;U++)Qt+=e[U][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),ni=e[0],Qt=ni.length;let U=e;if(D==2){U=e.slice();let F=U[0]=Array(Qt);for(let X=0;X<Qt;X++)F[X]=X}i._data=e=U}if(ct(!0),Cn("setData"),D==2&&(ye=!0),R!==!1){let U=C;U.auto(i,Is)?Jo():Ds(A,U.min,U.max),te=te||de.left>=0,me=!0,Un()}}i.setData=Ko;function Jo(){Is=!0;let w,R;s==1&&(Qt>0?(rn=zi[0]=0,on=zi[1]=Qt-1,w=e[0][rn],R=e[0][on],D==2?(w=rn,R=on):w==R&&(D==3?[w,R]=$u(w,w,C.log,!1):D==4?[w,R]=qf(w,w,C.log,!1):C.time?R=w+Mn(86400/m):[w,R]=Gu(w,R,Yf,!0))):(rn=zi[0]=w=null,on=zi[1]=R=null)),Ds(A,w,R)}let Fr,Ls,Br,P,W,j,Z,K,Ee,Pe;function Te(w,R,U,F,X,J){w??=ux,U??=Kf,F??="butt",X??=ux,J??="round",w!=Fr&&(h.strokeStyle=Fr=w),X!=Ls&&(h.fillStyle=Ls=X),R!=Br&&(h.lineWidth=Br=R),J!=W&&(h.lineJoin=W=J),F!=j&&(h.lineCap=j=F),U!=P&&h.setLineDash(P=U)}function Ie(w,R,U,F){R!=Ls&&(h.fillStyle=Ls=R),w!=Z&&(h.font=Z=w),U!=K&&(h.textAlign=K=U),F!=Ee&&(h.textBaseline=Ee=F)}function Be(w,R,U,F,X=0){if(F.length>0&&w.auto(i,Is)&&(R==null||R.min==null)){let J=Mt(rn,0),le=Mt(on,F.length-1),pe=U.min==null?lC(F,J,le,X,w.distr==3):[U.min,U.max];w.min=Fi(w.min,U.min=pe[0]),w.max=jn(w.max,U.max=pe[1])}}let tt={min:null,max:null};function dt(){for(let F in v){let X=v[F];B[F]==null&&(X.min==null||B[A]!=null&&X.auto(i,Is))&&(B[F]=tt)}for(let F in v){let X=v[F];B[F]==null&&X.from!=null&&B[X.from]!=null&&(B[F]=tt)}B[A]!=null&&ct(!0);let w={};for(let F in B){let X=B[F];if(X!=null){let J=w[F]=zo(v[F],xC);if(X.min!=null)gn(J,X);else if(F!=A||s==2)if(Qt==0&&J.from==null){let le=J.range(i,null,null,F);J.min=le[0],J.max=le[1]}else J.min=Bt,J.max=-Bt}}if(Qt>0){_.forEach((F,X)=>{if(s==1){let J=F.scale,le=B[J];if(le==null)return;let pe=w[J];if(X==0){let ve=pe.range(i,pe.min,pe.max,J);pe.min=ve[0],pe.max=ve[1],rn=ki(pe.min,e[0]),on=ki(pe.max,e[0]),on-rn>1&&(e[0][rn]<pe.min&&rn++,e[0][on]>pe.max&&on--),F.min=ni[rn],F.max=ni[on]}else F.show&&F.auto&&Be(pe,le,F,e[X],F.sorted);F.idxs[0]=rn,F.idxs[1]=on}else if(X>0&&F.show&&F.auto){let[J,le]=F.facets,pe=J.scale,ve=le.scale,[Ne,De]=e[X],Ue=w[pe],it=w[ve];Ue!=null&&Be(Ue,B[pe],J,Ne,J.sorted),it!=null&&Be(it,B[ve],le,De,le.sorted),F.min=le.min,F.max=le.max}});for(let F in w){let X=w[F],J=B[F];if(X.from==null&&(J==null||J.min==null)){let le=X.range(i,X.min==Bt?null:X.min,X.max==-Bt?null:X.max,F);X.min=le[0],X.max=le[1]}}}for(let F in w){let X=w[F];if(X.from!=null){let J=w[X.from];if(J.min==null)X.min=X.max=null;else{let le=X.range(i,J.min,J.max,F);X.min=le[0],X.max=le[1]}}}let R={},U=!1;for(let F in w){let X=w[F],J=v[F];if(J.min!=X.min||J.max!=X.max){J.min=X.min,J.max=X.max;let le=J.distr;J._min=le==3?Ts(J.min):le==4?Pf(J.min,J.asinh):le==100?J.fwd(J.min):J.min,J._max=le==3?Ts(J.max):le==4?Pf(J.max,J.asinh):le==100?J.fwd(J.max):J.max,R[F]=U=!0}}if(U){_.forEach((F,X)=>{s==2?X>0&&R.y&&(F._paths=null):R[F.scale]&&(F._paths=null)});for(let F in R)ye=!0,Cn("setScale",F);he&&de.left>=0&&(te=me=!0)}for(let F in B)B[F]=null}function Fe(w){let R=Ff(rn-1,0,Qt-1),U=Ff(on+1,0,Qt-1);for(;w[R]==null&&R>0;)R--;for(;w[U]==null&&U<Qt-1;)U++;return[R,U]}function ft(){if(Qt>0){let w=_.some(R=>R._focus)&&Pe!=ke.alpha;w&&(h.globalAlpha=Pe=ke.alpha),_.forEach((R,U)=>{if(U>0&&R.show&&(Jt(U,!1),Jt(U,!0),R._paths==null)){let F=Pe;Pe!=R.alpha&&(h.globalAlpha=Pe=R.alpha);let X=s==2?[0,e[U][0].length-1]:Fe(e[U]);R._paths=R.paths(i,U,X[0],X[1]),Pe!=F&&(h.globalAlpha=Pe=F)}}),_.forEach((R,U)=>{if(U>0&&R.show){let F=Pe;Pe!=R.alpha&&(h.globalAlpha=Pe=R.alpha),R._paths!=null&&Rt(U,!1);{let X=R._paths!=null?R._paths.gaps:null,J=R.points.show(i,U,rn,on,X),le=R.points.filter(i,U,J,X);(J||le)&&(R.points._paths=R.points.paths(i,U,rn,on,le),Rt(U,!0))}Pe!=F&&(h.globalAlpha=Pe=F),Cn("drawSeries",U)}}),w&&(h.globalAlpha=Pe=1)}}function Jt(w,R){let U=R?_[w].points:_[w];U._stroke=U.stroke(i,w),U._fill=U.fill(i,w)}function Rt(w,R){let U=R?_[w].points:_[w],{stroke:F,fill:X,clip:J,flags:le,_stroke:pe=U._stroke,_fill:ve=U._fill,_width:Ne=U.width}=U._paths;Ne=zt(Ne*Et,3);let De=null,Ue=Ne%2/2;R&&ve==null&&(ve=Ne>0?"#fff":pe);let it=U.pxAlign==1&&Ue>0;if(it&&h.translate(Ue,Ue),!R){let wt=O-Ne/2,St=T-Ne/2,mt=q+Ne,Ke=ue+Ne;De=new Path2D,De.rect(wt,St,mt,Ke)}R?Oe(pe,Ne,U.dash,U.cap,ve,F,X,le,J):Pt(w,pe,Ne,U.dash,U.cap,ve,F,X,le,De,J),it&&h.translate(-Ue,-Ue)}function Pt(w,R,U,F,X,J,le,pe,ve,Ne,De){let Ue=!1;ve!=0&&E.forEach((it,wt)=>{if(it.series[0]==w){let St=_[it.series[1]],mt=e[it.series[1]],Ke=(St._paths||ll).band;ar(Ke)&&(Ke=it.dir==1?Ke[0]:Ke[1]);let We,$t=null;St.show&&Ke&&uC(mt,rn,on)?($t=it.fill(i,wt)||J,We=St._paths.clip):Ke=null,Oe(R,U,F,X,$t,le,pe,ve,Ne,De,We,Ke),Ue=!0}}),Ue||Oe(R,U,F,X,J,le,pe,ve,Ne,De)}let _n=Vo|Vf;function Oe(w,R,U,F,X,J,le,pe,ve,Ne,De,Ue){Te(w,R,U,F,X),(ve||Ne||Ue)&&(h.save(),ve&&h.clip(ve),Ne&&h.clip(Ne)),Ue?(pe&_n)==_n?(h.clip(Ue),De&&h.clip(De),gt(X,le),hn(w,J,R)):pe&Vf?(gt(X,le),h.clip(Ue),hn(w,J,R)):pe&Vo&&(h.save(),h.clip(Ue),De&&h.clip(De),gt(X,le),h.restore(),hn(w,J,R)):(gt(X,le),hn(w,J,R)),(ve||Ne||Ue)&&h.restore()}function hn(w,R,U){U>0&&(R instanceof Map?R.forEach((F,X)=>{h.strokeStyle=Fr=X,h.stroke(F)}):R!=null&&w&&h.stroke(R))}function gt(w,R){R instanceof Map?R.forEach((U,F)=>{h.fillStyle=Ls=F,h.fill(U)}):R!=null&&w&&h.fill(R)}function as(w,R,U,F){let X=b[w],J;if(F<=0)J=[0,0];else{let le=X._space=X.space(i,w,R,U,F),pe=X._incrs=X.incrs(i,w,R,U,F,le);J=IR(R,U,pe,F,le)}return X._found=J}function dn(w,R,U,F,X,J,le,pe,ve,Ne){let De=le%2/2;x==1&&h.translate(De,De),Te(pe,le,ve,Ne,pe),h.beginPath();let Ue,it,wt,St,mt=X+(F==0||F==3?-J:J);U==0?(it=X,St=mt):(Ue=X,wt=mt);for(let Ke=0;Ke<w.length;Ke++)R[Ke]!=null&&(U==0?Ue=wt=w[Ke]:it=St=w[Ke],h.moveTo(Ue,it),h.lineTo(wt,St));h.stroke(),x==1&&h.translate(-De,-De)}function zr(w){let R=!0;return b.forEach((U,F)=>{if(!U.show)return;let X=v[U.scale];if(X.min==null){U._show&&(R=!1,U._show=!1,ct(!1));return}else U._show||(R=!1,U._show=!0,ct(!1));let J=U.side,le=J%2,{min:pe,max:ve}=X,[Ne,De]=as(F,pe,ve,le==0?V:Re);if(De==0)return;let Ue=X.distr==2,it=U._splits=U.splits(i,F,pe,ve,Ne,De,Ue),wt=X.distr==2?it.map(We=>ni[We]):it,St=X.distr==2?ni[it[1]]-ni[it[0]]:Ne,mt=U._values=U.values(i,U.filter(i,wt,F,De,St),F,De,St);U._rotate=J==2?U.rotate(i,mt,F,De):0;let Ke=U._size;U._size=Mi(U.size(i,mt,F,w)),Ke!=null&&U._size!=Ke&&(R=!1)}),R}function Vi(w){let R=!0;return Zo.forEach((U,F)=>{let X=U(i,F,Bi,w);X!=wi[F]&&(R=!1),wi[F]=X}),R}function ls(){for(let w=0;w<b.length;w++){let R=b[w];if(!R.show||!R._show)continue;let U=R.side,F=U%2,X,J,le=R.stroke(i,w),pe=U==0||U==3?-1:1,[ve,Ne]=R._found;if(R.label!=null){let $n=R.labelGap*pe,ri=Mn((R._lpos+$n)*Et);Ie(R.labelFont[0],le,"center",U==2?"top":cx),h.save(),F==1?(X=J=0,h.translate(ri,Mn(T+ue/2)),h.rotate((U==3?-zu:zu)/2)):(X=Mn(O+q/2),J=ri);let fr=jx(R.label)?R.label(i,w,ve,Ne):R.label;h.fillText(fr,X,J),h.restore()}if(Ne==0)continue;let De=v[R.scale],Ue=F==0?q:ue,it=F==0?O:T,wt=R._splits,St=De.distr==2?wt.map($n=>ni[$n]):wt,mt=De.distr==2?ni[wt[1]]-ni[wt[0]]:ve,Ke=R.ticks,We=R.border,$t=Ke.show?Ke.size:0,tn=Mn($t*Et),Rn=Mn((R.alignTo==2?R._size-$t-R.gap:R.gap)*Et),Dt=R._rotate*-zu/180,nn=g(R._pos*Et),ii=(tn+Rn)*pe,Wn=nn+ii;J=F==0?Wn:0,X=F==1?Wn:0;let xi=R.font[0],Ai=R.align==1?Oo:R.align==2?Tf:Dt>0?Oo:Dt<0?Tf:F==0?"center":U==3?Tf:Oo,Wi=Dt||F==1?"middle":U==2?"top":cx;Ie(xi,le,Ai,Wi);let si=R.font[1]*R.lineGap,_i=wt.map($n=>g(a($n,De,Ue,it))),Ei=R._values;for(let $n=0;$n<Ei.length;$n++){let ri=Ei[$n];if(ri!=null){F==0?X=_i[$n]:J=_i[$n],ri=""+ri;let fr=ri.indexOf(`
`)==-1?[ri]:ri.split(/\n/gm);for(let Xn=0;Xn<fr.length;Xn++){let $p=fr[Xn];Dt?(h.save(),h.translate(X,J+Xn*si),h.rotate(Dt),h.fillText($p,0,0),h.restore()):h.fillText($p,X,J+Xn*si)}}}Ke.show&&dn(_i,Ke.filter(i,St,w,Ne,mt),F,U,nn,tn,zt(Ke.width*Et,3),Ke.stroke(i,w),Ke.dash,Ke.cap);let $i=R.grid;$i.show&&dn(_i,$i.filter(i,St,w,Ne,mt),F,F==0?2:1,F==0?T:O,F==0?ue:q,zt($i.width*Et,3),$i.stroke(i,w),$i.dash,$i.cap),We.show&&dn([nn],[1],F==0?1:0,F==0?1:2,F==1?T:O,F==1?ue:q,zt(We.width*Et,3),We.stroke(i,w),We.dash,We.cap)}Cn("drawAxes")}function ct(w){_.forEach((R,U)=>{U>0&&(R._paths=null,w&&(s==1?(R.min=null,R.max=null):R.facets.forEach(F=>{F.min=null,F.max=null})))})}let en=!1,Hn=!1,It=[];function fn(){Hn=!1;for(let w=0;w<It.length;w++)Cn(...It[w]);It.length=0}function Un(){en||(wC(Tp),en=!0)}function dl(w,R=!1){en=!0,Hn=R,w(i),Tp(),R&&It.length>0&&queueMicrotask(fn)}i.batch=dl;function Tp(){if(ae&&(dt(),ae=!1),ye&&(Ae(),ye=!1),_e){if(Yt(f,Oo,Ze),Yt(f,"top",rt),Yt(f,sl,V),Yt(f,rl,Re),Yt(p,Oo,Ze),Yt(p,"top",rt),Yt(p,sl,V),Yt(p,rl,Re),Yt(d,sl,jt),Yt(d,rl,un),u.width=Mn(jt*Et),u.height=Mn(un*Et),b.forEach(({_el:w,_show:R,_size:U,_pos:F,side:X})=>{if(w!=null)if(R){let J=X===3||X===0?U:0,le=X%2==1;Yt(w,le?"left":"top",F-J),Yt(w,le?"width":"height",U),Yt(w,le?"top":"left",le?rt:Ze),Yt(w,le?"height":"width",le?Re:V),Uf(w,Nr)}else pi(w,Nr)}),Fr=Ls=Br=W=j=Z=K=Ee=P=null,Pe=1,ea(!0),Ze!=we||rt!=kt||V!=ze||Re!=Xe){ct(!1);let w=V/ze,R=Re/Xe;if(he&&!te&&de.left>=0){de.left*=w,de.top*=R,Vr&&is(Vr,Mn(de.left),0,V,Re),Gr&&is(Gr,0,Mn(de.top),V,Re);for(let U=0;U<ot.length;U++){let F=ot[U];F!=null&&(Gt[U]*=w,Gn[U]*=R,is(F,Mi(Gt[U]),Mi(Gn[U]),V,Re))}}if(Wt.show&&!re&&Wt.left>=0&&Wt.width>0){Wt.left*=w,Wt.width*=w,Wt.top*=R,Wt.height*=R;for(let U in Th)Yt($r,U,Wt[U])}we=Ze,kt=rt,ze=V,Xe=Re}Cn("setSize"),_e=!1}jt>0&&un>0&&(h.clearRect(0,0,u.width,u.height),Cn("drawClear"),M.forEach(w=>w()),Cn("draw")),Wt.show&&re&&(fl(Wt),re=!1),he&&te&&(dr(null,!0,!1),te=!1),fe.show&&fe.live&&me&&(Ah(),me=!1),l||(l=!0,i.status=1,Cn("ready")),Is=!1,en=!1}i.redraw=(w,R)=>{ye=R||!1,w!==!1?Ds(A,C.min,C.max):Un()};function Sh(w,R){let U=v[w];if(U.from==null){if(Qt==0){let F=U.range(i,R.min,R.max,w);R.min=F[0],R.max=F[1]}if(R.min>R.max){let F=R.min;R.min=R.max,R.max=F}if(Qt>1&&R.min!=null&&R.max!=null&&R.max-R.min<1e-16)return;w==A&&U.distr==2&&Qt>0&&(R.min=ki(R.min,e[0]),R.max=ki(R.max,e[0]),R.min==R.max&&R.max++),B[w]=R,ae=!0,Un()}}i.setScale=Sh;let Mh,wh,Vr,Gr,Cp,Rp,Hr,Wr,Pp,Ip,Ht,Kt,Ns=!1,Ln=de.drag,En=Ln.x,Tn=Ln.y;he&&(de.x&&(Mh=Si(YT,p)),de.y&&(wh=Si(ZT,p)),C.ori==0?(Vr=Mh,Gr=wh):(Vr=wh,Gr=Mh),Ht=de.left,Kt=de.top);let Wt=i.select=gn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),$r=Wt.show?Si(qT,Wt.over?p:f):null;function fl(w,R){if(Wt.show){for(let U in w)Wt[U]=w[U],U in Th&&Yt($r,U,w[U]);R!==!1&&Cn("setSelect")}}i.setSelect=fl;function vv(w){if(_[w].show)ee&&Uf(st[w],Nr);else if(ee&&pi(st[w],Nr),he){let U=Ce?ot[0]:ot[w];U!=null&&is(U,-10,-10,V,Re)}}function Ds(w,R,U){Sh(w,{min:R,max:U})}function Gi(w,R,U,F){R.focus!=null&&Av(w),R.show!=null&&_.forEach((X,J)=>{J>0&&(w==J||w==null)&&(X.show=R.show,vv(J),s==2?(Ds(X.facets[0].scale,null,null),Ds(X.facets[1].scale,null,null)):Ds(X.scale,null,null),Un())}),U!==!1&&Cn("setSeries",w,R),F&&ta("setSeries",i,w,R)}i.setSeries=Gi;function bv(w,R){gn(E[w],R)}function Sv(w,R){w.fill=yt(w.fill||null),w.dir=Mt(w.dir,-1),R=R??E.length,E.splice(R,0,w)}function Mv(w){w==null?E.length=0:E.splice(w,1)}i.addBand=Sv,i.setBand=bv,i.delBand=Mv;function wv(w,R){_[w].alpha=R,he&&ot[w]!=null&&(ot[w].style.opacity=R),ee&&st[w]&&(st[w].style.opacity=R)}let cs,Os,hr,Xr={focus:!0};function Av(w){if(w!=hr){let R=w==null,U=ke.alpha!=1;_.forEach((F,X)=>{if(s==1||X>0){let J=R||X==0||X==w;F._focus=R?null:J,U&&wv(X,J?1:ke.alpha)}}),hr=w,U&&Un()}}ee&&je&&vt(fx,Se,w=>{de._lock||(Je(w),hr!=null&&Gi(null,Xr,!0,pn.setSeries))});function Hi(w,R,U){let F=v[R];U&&(w=w/Et-(F.ori==1?rt:Ze));let X=V;F.ori==1&&(X=Re,w=X-w),F.dir==-1&&(w=X-w);let J=F._min,le=F._max,pe=w/X,ve=J+(le-J)*pe,Ne=F.distr;return Ne==3?Fo(10,ve):Ne==4?dC(ve,F.asinh):Ne==100?F.bwd(ve):ve}function Ev(w,R){let U=Hi(w,A,R);return ki(U,e[0],rn,on)}i.valToIdx=w=>ki(w,e[0]),i.posToIdx=Ev,i.posToVal=Hi,i.valToPos=(w,R,U)=>v[R].ori==0?r(w,v[R],U?q:V,U?O:0):o(w,v[R],U?ue:Re,U?T:0),i.setCursor=(w,R,U)=>{Ht=w.left,Kt=w.top,dr(null,R,U)};function Lp(w,R){Yt($r,Oo,Wt.left=w),Yt($r,sl,Wt.width=R)}function Np(w,R){Yt($r,"top",Wt.top=w),Yt($r,rl,Wt.height=R)}let jo=C.ori==0?Lp:Np,Qo=C.ori==1?Lp:Np;function Tv(){if(ee&&fe.live)for(let w=s==2?1:0;w<_.length;w++){if(w==0&&lt)continue;let R=fe.values[w],U=0;for(let F in R)Ve[w][U++].firstChild.nodeValue=R[F]}}function Ah(w,R){if(w!=null&&(w.idxs?w.idxs.forEach((U,F)=>{ie[F]=U}):gC(w.idx)||ie.fill(w.idx),fe.idx=ie[0]),ee&&fe.live){for(let U=0;U<_.length;U++)(U>0||s==1&&!lt)&&Cv(U,ie[U]);Tv()}me=!1,R!==!1&&Cn("setLegend")}i.setLegend=Ah;function Cv(w,R){let U=_[w],F=w==0&&D==2?ni:e[w],X;lt?X=U.values(i,w,R)??nt:(X=U.value(i,R==null?null:F[R],w,R),X=X==null?nt:{_:X}),fe.values[w]=X}function dr(w,R,U){Pp=Ht,Ip=Kt,[Ht,Kt]=de.move(i,Ht,Kt),de.left=Ht,de.top=Kt,he&&(Vr&&is(Vr,Mn(Ht),0,V,Re),Gr&&is(Gr,0,Mn(Kt),V,Re));let F,X=rn>on;cs=Bt,Os=null;let J=C.ori==0?V:Re,le=C.ori==1?V:Re;if(Ht<0||Qt==0||X){F=de.idx=null;for(let pe=0;pe<_.length;pe++){let ve=ot[pe];ve!=null&&is(ve,-10,-10,V,Re)}je&&Gi(null,Xr,!0,w==null&&pn.setSeries),fe.live&&(ie.fill(F),me=!0)}else{let pe,ve,Ne;s==1&&(pe=C.ori==0?Ht:Kt,ve=Hi(pe,A),F=de.idx=ki(ve,e[0],rn,on),Ne=k(e[0][F],C,J,0));let De=-10,Ue=-10,it=0,wt=0,St=!0,mt="",Ke="";for(let We=s==2?1:0;We<_.length;We++){let $t=_[We],tn=ie[We],Rn=tn==null?null:s==1?e[We][tn]:e[We][1][tn],Dt=de.dataIdx(i,We,F,ve),nn=Dt==null?null:s==1?e[We][Dt]:e[We][1][Dt];if(me=me||nn!=Rn||Dt!=tn,ie[We]=Dt,We>0&&$t.show){let ii=Dt==null?-10:Dt==F?Ne:k(s==1?e[0][Dt]:e[We][0][Dt],C,J,0),Wn=nn==null?-10:N(nn,s==1?v[$t.scale]:v[$t.facets[1].scale],le,0);if(je&&nn!=null){let xi=C.ori==1?Ht:Kt,Ai=wn(ke.dist(i,We,Dt,Wn,xi));if(Ai<cs){let Wi=ke.bias;if(Wi!=0){let si=Hi(xi,$t.scale),_i=nn>=0?1:-1,Ei=si>=0?1:-1;Ei==_i&&(Ei==1?Wi==1?nn>=si:nn<=si:Wi==1?nn<=si:nn>=si)&&(cs=Ai,Os=We)}else cs=Ai,Os=We}}if(me||Ce){let xi,Ai;C.ori==0?(xi=ii,Ai=Wn):(xi=Wn,Ai=ii);let Wi,si,_i,Ei,$i,$n,ri=!0,fr=ce.bbox;if(fr!=null){ri=!1;let Xn=fr(i,We);_i=Xn.left,Ei=Xn.top,Wi=Xn.width,si=Xn.height}else _i=xi,Ei=Ai,Wi=si=ce.size(i,We);if($n=ce.fill(i,We),$i=ce.stroke(i,We),Ce)We==Os&&cs<=ke.prox&&(De=_i,Ue=Ei,it=Wi,wt=si,St=ri,mt=$n,Ke=$i);else{let Xn=ot[We];Xn!=null&&(Gt[We]=_i,Gn[We]=Ei,vx(Xn,Wi,si,ri),_x(Xn,$n,$i),is(Xn,Mi(_i),Mi(Ei),V,Re))}}}}if(Ce){let We=ke.prox,$t=hr==null?cs<=We:cs>We||Os!=hr;if(me||$t){let tn=ot[0];tn!=null&&(Gt[0]=De,Gn[0]=Ue,vx(tn,it,wt,St),_x(tn,mt,Ke),is(tn,Mi(De),Mi(Ue),V,Re))}}}if(Wt.show&&Ns)if(w!=null){let[pe,ve]=pn.scales,[Ne,De]=pn.match,[Ue,it]=w.cursor.sync.scales,wt=w.cursor.drag;if(En=wt._x,Tn=wt._y,En||Tn){let{left:St,top:mt,width:Ke,height:We}=w.select,$t=w.scales[Ue].ori,tn=w.posToVal,Rn,Dt,nn,ii,Wn,xi=pe!=null&&Ne(pe,Ue),Ai=ve!=null&&De(ve,it);xi&&En?($t==0?(Rn=St,Dt=Ke):(Rn=mt,Dt=We),nn=v[pe],ii=k(tn(Rn,Ue),nn,J,0),Wn=k(tn(Rn+Dt,Ue),nn,J,0),jo(Fi(ii,Wn),wn(Wn-ii))):jo(0,J),Ai&&Tn?($t==1?(Rn=St,Dt=Ke):(Rn=mt,Dt=We),nn=v[ve],ii=N(tn(Rn,it),nn,le,0),Wn=N(tn(Rn+Dt,it),nn,le,0),Qo(Fi(ii,Wn),wn(Wn-ii))):Qo(0,le)}else Ch()}else{let pe=wn(Pp-Cp),ve=wn(Ip-Rp);if(C.ori==1){let it=pe;pe=ve,ve=it}En=Ln.x&&pe>=Ln.dist,Tn=Ln.y&&ve>=Ln.dist;let Ne=Ln.uni;Ne!=null?En&&Tn&&(En=pe>=Ne,Tn=ve>=Ne,!En&&!Tn&&(ve>pe?Tn=!0:En=!0)):Ln.x&&Ln.y&&(En||Tn)&&(En=Tn=!0);let De,Ue;En&&(C.ori==0?(De=Hr,Ue=Ht):(De=Wr,Ue=Kt),jo(Fi(De,Ue),wn(Ue-De)),Tn||Qo(0,le)),Tn&&(C.ori==1?(De=Hr,Ue=Ht):(De=Wr,Ue=Kt),Qo(Fi(De,Ue),wn(Ue-De)),En||jo(0,J)),!En&&!Tn&&(jo(0,0),Qo(0,0))}if(Ln._x=En,Ln._y=Tn,w==null){if(U){if(Wp!=null){let[pe,ve]=pn.scales;pn.values[0]=pe!=null?Hi(C.ori==0?Ht:Kt,pe):null,pn.values[1]=ve!=null?Hi(C.ori==1?Ht:Kt,ve):null}ta(Cf,i,Ht,Kt,V,Re,F)}if(je){let pe=U&&pn.setSeries,ve=ke.prox;hr==null?cs<=ve&&Gi(Os,Xr,!0,pe):cs>ve?Gi(null,Xr,!0,pe):Os!=hr&&Gi(Os,Xr,!0,pe)}}me&&(fe.idx=F,Ah()),R!==!1&&Cn("setCursor")}let Us=null;Object.defineProperty(i,"rect",{get(){return Us==null&&ea(!1),Us}});function ea(w=!1){w?Us=null:(Us=p.getBoundingClientRect(),Cn("syncRect",Us))}function Dp(w,R,U,F,X,J,le){de._lock||Ns&&w!=null&&w.movementX==0&&w.movementY==0||(Eh(w,R,U,F,X,J,le,!1,w!=null),w!=null?dr(null,!0,!0):dr(R,!0,!1))}function Eh(w,R,U,F,X,J,le,pe,ve){if(Us==null&&ea(!1),Je(w),w!=null)U=w.clientX-Us.left,F=w.clientY-Us.top;else{if(U<0||F<0){Ht=-10,Kt=-10;return}let[Ne,De]=pn.scales,Ue=R.cursor.sync,[it,wt]=Ue.values,[St,mt]=Ue.scales,[Ke,We]=pn.match,$t=R.axes[0].side%2==1,tn=C.ori==0?V:Re,Rn=C.ori==1?V:Re,Dt=$t?J:X,nn=$t?X:J,ii=$t?F:U,Wn=$t?U:F;if(St!=null?U=Ke(Ne,St)?a(it,v[Ne],tn,0):-10:U=tn*(ii/Dt),mt!=null?F=We(De,mt)?a(wt,v[De],Rn,0):-10:F=Rn*(Wn/nn),C.ori==1){let xi=U;U=F,F=xi}}ve&&(R==null||R.cursor.event.type==Cf)&&((U<=1||U>=V-1)&&(U=Ir(U,V)),(F<=1||F>=Re-1)&&(F=Ir(F,Re))),pe?(Cp=U,Rp=F,[Hr,Wr]=de.move(i,U,F)):(Ht=U,Kt=F)}let Th={width:0,height:0,left:0,top:0};function Ch(){fl(Th,!1)}let Op,Up,kp,Fp;function Bp(w,R,U,F,X,J,le){Ns=!0,En=Tn=Ln._x=Ln._y=!1,Eh(w,R,U,F,X,J,le,!0,!1),w!=null&&(vt(Rf,Df,zp,!1),ta(hx,i,Hr,Wr,V,Re,null));let{left:pe,top:ve,width:Ne,height:De}=Wt;Op=pe,Up=ve,kp=Ne,Fp=De}function zp(w,R,U,F,X,J,le){Ns=Ln._x=Ln._y=!1,Eh(w,R,U,F,X,J,le,!1,!0);let{left:pe,top:ve,width:Ne,height:De}=Wt,Ue=Ne>0||De>0,it=Op!=pe||Up!=ve||kp!=Ne||Fp!=De;if(Ue&&it&&fl(Wt),Ln.setScale&&Ue&&it){let wt=pe,St=Ne,mt=ve,Ke=De;if(C.ori==1&&(wt=ve,St=De,mt=pe,Ke=Ne),En&&Ds(A,Hi(wt,A),Hi(wt+St,A)),Tn)for(let We in v){let $t=v[We];We!=A&&$t.from==null&&$t.min!=Bt&&Ds(We,Hi(mt+Ke,We),Hi(mt,We))}Ch()}else de.lock&&(de._lock=!de._lock,dr(R,!0,w!=null));w!=null&&(xn(Rf,Df),ta(Rf,i,Ht,Kt,V,Re,null))}function Rv(w,R,U,F,X,J,le){if(de._lock)return;Je(w);let pe=Ns;if(Ns){let ve=!0,Ne=!0,De=10,Ue,it;C.ori==0?(Ue=En,it=Tn):(Ue=Tn,it=En),Ue&&it&&(ve=Ht<=De||Ht>=V-De,Ne=Kt<=De||Kt>=Re-De),Ue&&ve&&(Ht=Ht<Hr?0:V),it&&Ne&&(Kt=Kt<Wr?0:Re),dr(null,!0,!0),Ns=!1}Ht=-10,Kt=-10,ie.fill(null),dr(null,!0,!0),pe&&(Ns=pe)}function Vp(w,R,U,F,X,J,le){de._lock||(Je(w),Jo(),Ch(),w!=null&&ta(px,i,Ht,Kt,V,Re,null))}function Gp(){b.forEach(LR),z(i.width,i.height,!0)}Dr(Vu,ko,Gp);let qr={};qr.mousedown=Bp,qr.mousemove=Dp,qr.mouseup=zp,qr.dblclick=Vp,qr.setSeries=(w,R,U,F)=>{let X=pn.match[2];U=X(i,R,U),U!=-1&&Gi(U,F,!0,!1)},he&&(vt(hx,p,Bp),vt(Cf,p,Dp),vt(dx,p,w=>{Je(w),ea(!1)}),vt(fx,p,Rv),vt(px,p,Vp),Gf.add(i),i.syncRect=ea);let pl=i.hooks=n.hooks||{};function Cn(w,R,U){Hn?It.push([w,R,U]):w in pl&&pl[w].forEach(F=>{F.call(null,i,R,U)})}(n.plugins||[]).forEach(w=>{for(let R in w.hooks)pl[R]=(pl[R]||[]).concat(w.hooks[R])});let Hp=(w,R,U)=>U,pn=gn({key:null,setSeries:!1,filters:{pub:Ax,sub:Ax},scales:[A,_[1]?_[1].scale:null],match:[Ex,Ex,Hp],values:[null,null]},de.sync);pn.match.length==2&&pn.match.push(Hp),de.sync=pn;let Wp=pn.key,Rh=S_(Wp);function ta(w,R,U,F,X,J,le){pn.filters.pub(w,R,U,F,X,J,le)&&Rh.pub(w,R,U,F,X,J,le)}Rh.sub(i);function Pv(w,R,U,F,X,J,le){pn.filters.sub(w,R,U,F,X,J,le)&&qr[w](null,R,U,F,X,J,le)}i.pub=Pv;function Iv(){Rh.unsub(i),Gf.delete(i),An.clear(),kf(Vu,ko,Gp),c.remove(),Se?.remove(),Cn("destroy")}i.destroy=Iv;function Ph(){Cn("init",n,e),Ko(e||n.data,!1),B[A]?Sh(A,B[A]):Jo(),re=Wt.show&&(Wt.width>0||Wt.height>0),te=me=!0,z(n.width,n.height)}return _.forEach(kr),b.forEach(rs),t?t instanceof HTMLElement?(t.appendChild(c),Ph()):t(i,Ph):Ph(),i}ln.assign=gn;ln.fmtNum=Zf;ln.rangeNum=Gu;ln.rangeLog=$u;ln.rangeAsinh=qf;ln.orient=Ur;ln.pxRatio=Et;ln.join=MC;ln.fmtDate=Jf,ln.tzDate=DC;ln.sync=S_;{ln.addGap=gR,ln.clipGaps=Yu;let n=ln.paths={points:C_};n.linear=P_,n.stepped=yR,n.bars=vR,n.spline=SR}var NR=20,[DR,D_,ju]=[46,14,4],O_=18,Qu=26,OR=16,eh=12;function U_(n,{name:e,lines:t,word:i="",under:s=()=>[],over:r=()=>[],lookOf:o=Di}){return t0(()=>{let a=n.data.slice(1).map((g,m)=>o(m)),[l,c]=[n.bbox.width/devicePixelRatio,n.bbox.height/devicePixelRatio],u=NR+n.axes[1]._size,h=u+l+D_,d=UR(i,t,a,u,h-D_),f=d.height+8,p=[...s(),...kR(n,l,c),{kind:"clip",x:0,y:0,width:l,height:c,shapes:FR(n,a)},{kind:"path",points:[[0,0],[0,c],[l,c]],stroke:_t("--ink")},...r(),...BR(n,e,l,c,u)],x=f+c+DR;return{svg:Mu([...d.shapes,{kind:"moved",x:u,y:f,shapes:p}],h,x,e),width:h,height:x}})}function UR(n,e,t,i,s){let r=document.createElement("canvas").getContext("2d");r.font=`${eh}px system-ui, sans-serif`;let o=[],[a,l]=[i,O_-4],c=_t("--ink"),u=(h,d)=>{let f=d+r.measureText(h).width;a>i&&a+f>s&&([a,l]=[i,l+O_]);let p=a;return a+=f+OR,p};n&&o.push({kind:"text",x:u(n,0),y:l,text:n,size:eh,fill:c});for(let[h,d]of e.entries()){let f=u(d,Qu),{colour:p,dash:x,area:g}=t[h];g?o.push({kind:"rect",x:f,y:l-9,width:Qu-6,height:9,fill:p}):o.push({kind:"path",points:[[f,l-4],[f+Qu-6,l-4]],stroke:p,lineWidth:1.6,dash:x}),o.push({kind:"text",x:f+Qu,y:l,text:d,size:eh,fill:c})}return{shapes:o,height:o.length?l+4:0}}function th(n,e,t){let{_splits:i,_values:s}=n.axes[e];return i.flatMap((r,o)=>s[o]?[[n.valToPos(r,t),s[o]]]:[])}function kR(n,e,t){let i=(...s)=>({kind:"path",points:s,stroke:_t("--grid")});return[...th(n,0,"x").map(([s])=>i([s,0],[s,t])),...th(n,1,"y").map(([s])=>i([0,s],[e,s]))]}function FR(n,e){let[t,...i]=n.data;return i.map((s,r)=>{let{colour:o,dash:a,area:l}=e[r],c=[];for(let d=0;d<t.length;d++)s[d]===null||s[d]===void 0||Number.isNaN(s[d])||c.push([n.valToPos(t[d],"x"),n.valToPos(s[d],"y")]);if(!l||!c.length)return{kind:"path",points:c,stroke:o,lineWidth:1.6,dash:a};let u=n.valToPos(0,"y"),h=[c.at(-1),c[0]].map(([d])=>[d,u]);return{kind:"path",points:[...c,...h],fill:o,stroke:_t("--page"),lineWidth:.5}})}function BR(n,e,t,i,s){let[r,o]=[_t("--ink"),_t("--ink")],a=(c,u,h,d)=>({kind:"text",x:c,y:u,text:h,size:eh,fill:r,...d}),{label:l}=n.axes[0];return[...th(n,0,"x").flatMap(([c,u])=>[{kind:"path",points:[[c,i],[c,i+ju]],stroke:o},a(c,i+ju+13,u,{anchor:"middle"})]),...th(n,1,"y").flatMap(([c,u])=>[{kind:"path",points:[[0,c],[-ju,c]],stroke:o},a(-ju-4,c+4,u,{anchor:"end"})]),a(t/2,i+38,typeof l=="function"?l():l,{anchor:"middle"}),a(12-s,i/2,Ot(e),{anchor:"middle",turned:!0})]}var rh=210,zR=64,VR=.02,GR=[.01,.02,.05,.1,.2,.5,1,2,5,10,15,30,45,90,180,360,...eP(3,20)];function cr(n,e,t,i){let s=e.map(o=>HR(o,t)),r=e.map((o,a)=>{let l=o.sharing?s.filter((c,u)=>e[u].sharing===o.sharing).flat():null;return $R(o,s[a].map(c=>c.values),l,t,i)});n.replaceChildren(...r.map(o=>o.element)),n.classList.add("plots");for(let o of r)o.start();return{charts:r.map(o=>o.chart),dispose:()=>r.forEach(o=>o.dispose())}}function HR(n,e){return n.lines.map(t=>({clip:t.clip,values:t.readings?e[t.clip].line(t.readings,t.part):qt(t.values,Float32Array)}))}function WR(n,e,t){let i=[1/0,-1/0];for(let{clip:s,values:r}of n){let o=e[s].time;for(let a=0;a<o.length;a++){let l=o[a]-t.origins[s];l<t.start||l>t.end||(r[a]<i[0]&&(i[0]=r[a]),r[a]>i[1]&&(i[1]=r[a]))}}return i}function nh(n){let[e,...t]=n.lines.map(i=>i.clip);return t.every(i=>i===e)?e??null:null}function $R(n,e,t,i,s){let{element:r,head:o,key:a,place:l}=sp(n,n.owner),c=S("div",{className:"cursor"}),u=n.ball===void 0?null:S("div",{className:"ball"}),h=null,d=null,f=!1,p=[],x=new ResizeObserver(()=>h?.setSize({width:l.clientWidth,height:rh}));function g(){let{word:E}=n,A=F_(n).map((y,M)=>S("li",{},pr(ih(n,M)),y));a.replaceChildren(...E?[S("li",{},E)]:[],...A)}function m(){(s.span!==d||s.stretched!==f)&&(d=s.span,f=s.stretched,h.setData(k_(n,e,i,d),!1),h.setScale("x",{min:d.start,max:d.end}));let E=h.valToPos(s.time,"x").toFixed(2);c.style.transform=`translateX(${E}px)`,u&&(u.style.transform=`translate(${E}px, ${h.valToPos(_(),"y").toFixed(2)}px)`)}function _(){let{clip:E}=n.lines[n.ball];return tr(i[E].time,e[n.ball],s.clipTime(E))}function b(){d=s.span,f=s.stretched,h=new ln(YR(n,t,i,s,l.clientWidth),k_(n,e,i,d),l),h.setScale("x",{min:d.start,max:d.end}),h.over.append(c,...u?[u]:[]),QR(h,s),x.observe(l),h.hooks.setSize=[m];let E=()=>{g(),h.redraw(!1)};p=[s.onChange(m),Qs(E)],g();let A=nh(n);o.append(rp(n,()=>h,{under:()=>z_(h,i,A,s.span),over:()=>V_(h,i,A,s.span)}))}function v(){for(let E of p)E();x.disconnect(),h.destroy()}return{element:r,start:b,dispose:v,get chart(){return h}}}function sp(n,e=null){let t=e?`${Ot(e)}. ${n.text}`:n.text,i=S("div",{className:"chart",role:"img","aria-label":t}),s=S("ul",{className:"key"}),r=S("h2",{},`${Ot(n.title)} (${n.unit})`);e&&r.append(S("small",{},e));let o=S("div",{className:"head"},r);return{element:S("figure",{},o,s,i,S("figcaption",{},n.text)),head:o,key:s,place:i}}function F_({lines:n,word:e}){return n.map(({name:t})=>e?t.slice(e.length+1):t)}function ih({lines:n,stacked:e},t){let{area:i,look:s}=n[t];return i?{colour:i.startsWith("--")?_t(i):i,dash:[],area:!0}:e?{colour:_t("--ink"),dash:[]}:Di(s??t)}function rp(n,e,{under:t,over:i}){let s=n.owner?`${n.title}, ${n.owner}`:n.title;return Xi(s,()=>qn(s),()=>U_(e(),{name:`${n.title} (${n.unit})`,lines:F_(n),word:n.word,under:t,over:i,lookOf:n.stacked?o=>ih(n,o):void 0}))}function k_(n,e,t,i){if(n.stacked)return XR(n,e,t[n.lines[0].clip],i.origins[n.lines[0].clip]+i.start,i);let s=n.lines.map((r,o)=>[Float64Array.from(t[r.clip].time,a=>a-i.origins[r.clip]),e[o]]);return nh(n)!==null?[s[0]?.[0]??[],...s.map(r=>r[1])]:ln.join(s)}function XR({lines:n},e,t,i,s){let r=n.map(({since:a},l)=>{let c=a===void 0?0:tr(t.time,e[a],i);return Float64Array.from(e[l],u=>u-c)}),o=new Float64Array(t.time.length);for(let a=n.length-1;a>=0;a--)if(n[a].area){for(let l=0;l<o.length;l++)o[l]+=r[a][l];r[a].set(o)}return[Float64Array.from(t.time,a=>a-s.origins[n[0].clip]),...r]}function qR(n){return n.lines.map(({area:e},t)=>({stroke:()=>e?_t("--page"):ih(n,t).colour,...e?{fill:()=>ih(n,t).colour,fillTo:0}:{},width:e?.5:1.6,points:{show:!1}}))}function YR(n,e,t,i,s){let r=oh(),o=(a,l,c)=>JR(n,...e?WR(e,t,i.span):[l,c]);return{width:s,height:rh,legend:{show:!1},cursor:{show:!1},padding:[8,10,0,0],scales:{x:{time:!1,auto:!1,distr:100,fwd:i.shareAt,bwd:i.momentAt},y:{range:o}},series:[{},...n.stacked?qR(n):op(n.lines)],axes:[{...r,...ap,labelFont:r.font,label:()=>`${i.span.label} (${na(i.span).unit})${i.stretched?", stretched":""}`,filter:(a,l)=>l,splits:(a,l,c,u,h)=>i.stretched?ZR(a,i):KR(c,u,h),values:(a,l)=>l.map(c=>c===null?"":B_(c*na(i.span).factor)),space:56},lp(n)],hooks:{drawClear:[a=>sh(a,z_(a,t,nh(n),i.span))],draw:[a=>sh(a,V_(a,t,nh(n),i.span))]}}}function ZR(n,e){let t=Math.max(2,Math.floor(n.bbox.width/devicePixelRatio/zR)),{factor:i}=na(e.span),s=new Set;for(let r=0;r<=t;r++){let o=e.momentAt(r/t),a=[1,2,3,4,5,6].map(c=>Number((i*o).toPrecision(c))/i),l=c=>Math.abs(e.shareAt(c)-r/t)<.2/t;s.add(a.find(l)??a[a.length-1])}return[...s].filter(r=>r>=e.span.start&&r<=e.span.end)}function KR(n,e,t){let i=Math.ceil(n/t-1e-9);return Array.from({length:Math.floor(e/t+1e-9)-i+1},(s,r)=>(i+r)*t)}function op(n){return n.map(({look:e},t)=>({stroke:()=>Di(e??t).colour,dash:Di(e??t).dash,width:1.6,points:{show:!1},spanGaps:!0}))}var ap={size:24,gap:3,labelSize:18,labelGap:0};function oh(){return{stroke:()=>_t("--muted"),grid:{stroke:()=>_t("--grid"),width:1},ticks:{stroke:()=>_t("--grid"),width:1,size:4},font:"12px system-ui, sans-serif"}}function lp(n){return{...oh(),size:(e,t)=>Math.max(48,16+7*Math.max(0,...(t??[]).map(i=>i.length))),gap:3,values:(e,t)=>t.map(i=>i===null?"":B_(i)),...n.unit==="deg"?{incrs:GR,space:26}:{space:30}}}function JR(n,e,t){let[i,s]=jR(e,t)?[e,t]:[Math.min(0,e??0),Math.max(0,t??0)],r=.06*(s-i||1);return[n.unit==="deg"||i!==0?i-r:i,s+2*r]}function jR(n,e){let t=Math.max(Math.abs(n),Math.abs(e));return n*e>0&&Math.min(Math.abs(n),Math.abs(e))>t/2&&e-n>VR*t}function B_(n){let e=Math.abs(n)<1e-12?"0":String(Number(n.toPrecision(6)));return e.length>7?bt(n):e.replace("-","−")}function sh(n,e){let{ctx:t,bbox:i}=n;Ja(t,e,devicePixelRatio,[i.left/devicePixelRatio,i.top/devicePixelRatio])}function z_(n,e,t,i){if(t===null)return[];let[s,r]=[n.bbox.width/devicePixelRatio,n.bbox.height/devicePixelRatio];return e[t].stages.filter(o=>o.driven).map(o=>{let[a,l]=[o.start,o.end].map(c=>Math.min(s,Math.max(0,n.valToPos(c-i.origins[t],"x"))));return{kind:"rect",x:a,y:0,width:l-a,height:r,fill:_t("--band")}})}function V_(n,e,t,i){if(t===null)return[];let[s,r]=[n.bbox.width/devicePixelRatio,n.bbox.height/devicePixelRatio];return e[t].marks.flatMap(o=>{let a=n.valToPos(o.time-i.origins[t],"x");if(a<-1||a>s+1)return[];let l=a>s-16?-1:1;return[{kind:"path",points:[[a,0],[a,r]],stroke:_t("--muted"),dash:[2,3]},{kind:"rect",x:a+(l>0?2:-14),y:1,width:12,height:15,fill:_t("--page")},{kind:"text",x:a+l*8,y:13,text:o.letter,anchor:"middle",bold:!0,fill:_t("--ink")}]})}function QR(n,e){cp(n,t=>{e.pause(),e.seek(n.posToVal(t.clientX-n.over.getBoundingClientRect().left,"x"))})}function cp(n,e){n.over.addEventListener("pointerdown",t=>{t.button===0&&(n.over.setPointerCapture(t.pointerId),e(t))}),n.over.addEventListener("pointermove",t=>{n.over.hasPointerCapture(t.pointerId)&&e(t)})}function eP(n,e){return Array.from({length:e-n},(t,i)=>[1,2,5].map(s=>s*10**(n+i))).flat()}function ah(n,e){if(matchMedia("(prefers-reduced-motion: reduce)").matches)return;let t=new IntersectionObserver(i=>{i.some(s=>s.isIntersecting)&&(t.disconnect(),e.play())},{threshold:.3});t.observe(n.querySelector(".picture")??n),n.addEventListener("pointerdown",()=>t.disconnect(),{once:!0})}function G_(n){let e=n.clips.map(Jn),t=Oi(e,n.spans),i=rr(document.getElementById("player"),e,t,n);up(i.stage.cells,e,t,n.energy);let s=cr(document.getElementById("plots"),n.plots,e,t);return ah(document.getElementById("player"),t),{clips:e,clock:t,player:i,plots:s}}function up(n,e,t,i){let s=e.map((r,o)=>{let a=S("span",{className:"state-now"}),l=S("b",{},pr(Di(o)),r.name);return Qs(()=>l.replaceChild(pr(Di(o)),l.firstChild)),n[o].append(l,a),a});t.onChange(()=>{for(let[r,o]of e.entries()){let a=t.clipTime(r),c=[t.time+t.span.origins[r]>o.end?"ended":o.stageAt(a).name],[u]=o.readings;u&&c.push(tP(o.valuesAt(u.name,a),u.unit));let h=o.valuesAt(Es,a).reduce((d,f)=>d+f,0);o.tendons&&c.push(`${bt(i.factor*h)} ${i.unit}`),s[r].textContent=c.join(" · ")}})}function tP(n,e){let t=s=>e==="deg"?`${Nn(s,0)}°`:`${bt(s)} ${e}`,i=[Math.min(...n),Math.max(...n)].map(t);return i[0]===i[1]?i[0]:i.join(" to ")}function hp(n){return n.energy?Ro:e0}function H_(n,e){let t=n.at(e).map(s=>Math.round(255*s)),i=.299*t[0]+.587*t[1]+.114*t[2]>118;return{face:`rgb(${t.join(" ")})`,ink:i?"#000":"#fff"}}function $o({sign:n,pattern:e}){return S("span",{className:`what ${e}`,"aria-hidden":"true"},S("span",{},n))}function lh(n,e){let t=n.scaleOf(e);if(!t)return[];let i=S("span",{className:"bar","aria-hidden":"true"});return i.style.background=hp(e).gradient,[S("p",{className:"scale"},`${e.title} (${e.unit})`,S("span",{className:"whole"},t.text(t.low),i,t.text(t.high)))]}function ch(n,e){let{factors:t,quantities:i,words:s}=n,r=t.map(h=>h.values.length),o=new Map;for(let h of e)o.set(h.point,[...o.get(h.point)??[],h]);function a(h){if(n.sampled)return t.map(()=>h);let d=[];for(let f=r.length-1;f>=0;f--)d[f]=h%r[f],h=Math.floor(h/r[f]);return d}let l=h=>h.reduce((d,f,p)=>d*r[p]+f,0);function c(h){let f=(h.shares?i.filter(_=>_.group===h.group):[h]).flatMap(_=>_.values??[]).filter(_=>_!==null);if(!f.length)return null;let[p,x]=[f.reduce((_,b)=>Math.min(_,b)),f.reduce((_,b)=>Math.max(_,b))],g=_=>x>p?(_-p)/(x-p):.5,m=nP((h.values??[]).filter(_=>_!==null));return{low:p,high:x,colour:_=>H_(hp(h),g(_)),text:_=>ss(Number(_.toFixed(m)))}}let u=(h,d)=>`${h.name} ${h.texts[d]}${h.unit?` ${h.unit}`:""}`;return{study:n,sizes:r,numbers:i.filter(h=>h.values&&!h.tried),columns:t,shown:()=>!0,nameOf:()=>"",placesOf:a,pointAt:l,scaleOf:c,factorText:u,largestSpan:e.reduce((h,d)=>Math.max(h,d.play.clips[0].span_m),0),runsOf:h=>o.get(h)??[],word:h=>s[h],pointText:h=>a(h).map((d,f)=>u(t[f],d)).join(", "),valueText(h,d){let f=h.values?.[d]??null;return f===null?s[h.reasons[d]].word:`${ss(f)} ${h.unit}`}}}function nP(n){let e=n.reduce((t,i)=>Math.max(t,Math.abs(i)),0);return Math.min(20,Math.max(0,2-Math.floor(Math.log10(e||1))))}function ss(n){let e=Number(n.toPrecision(3));return(e!==0&&Math.abs(e)<.001?e.toExponential():String(e)).replaceAll("-","−")}var iP="http://www.w3.org/2000/svg";function Lt(n,e,...t){let i=document.createElementNS(iP,n);for(let[s,r]of Object.entries(e))i.setAttribute(s,r);return i.append(...t),i}function Xo({values:n,log:e},t=[]){let i=[...new Set(n.filter(d=>typeof d=="string"))];if(i.length)return{words:i,share:f=>(i.indexOf(f)+.5)/i.length,ticks:i,value:f=>i[Math.min(i.length-1,Math.max(0,Math.floor(f*i.length)))]};let s=[...n,...t].filter(d=>typeof d=="number"),r=e&&s.every(d=>d>0),[o,a]=r?[Math.log,Math.exp]:[d=>d,d=>d],l=s.reduce((d,f)=>Math.min(d,o(f)),1/0),c=s.reduce((d,f)=>Math.max(d,o(f)),-1/0),u=d=>c>l?(o(d)-l)/(c-l):.5,h=s.length?(r?sP:W_)(a(l),a(c)):[];return{words:i,share:u,ticks:h,value:d=>a(l+d*(c-l))}}function dp(n,e,t,i,s=[]){let r=e.unit?`${e.name} (${e.unit})`:e.name,o=Xo({values:n,log:e.log},s),a=.04*(i-t),l=u=>t+a+o.share(u)*(i-t-2*a),c=o.ticks.map(u=>[l(u),typeof u=="number"?ss(u):u]);return{label:r,from:t,to:i,ticks:c,at:l,place:u=>n[u]===null?t+.75*a:l(n[u])}}function W_(n,e){if(!(e>n))return[n];let t=(e-n)/5,i=10**Math.floor(Math.log10(t)),s=i*([1,2,5].find(o=>o*i>=t)??10),r=[];for(let o=Math.ceil(n/s)*s;o<=e+1e-9*s;o+=s)r.push(Number(o.toPrecision(12)));return r}function sP(n,e){if(!(e>n))return[n];let t=e/n>200?[1]:[1,2,5],i=[];for(let s=Math.floor(Math.log10(n));s<=Math.ceil(Math.log10(e));s++)for(let r of t){let o=Number((r*10**s).toPrecision(12));o>=n*(1-1e-9)&&o<=e*(1+1e-9)&&i.push(o)}return i.length>1?i:W_(n,e)}function $_(n,e,t){let i=[Lt("path",{class:"axis",d:`M${n.from} ${e.to}V${e.from}H${n.to}`})],s=(r,o)=>i.push(Lt("text",{class:"label",...o},r));for(let[r,o]of n.ticks)s(o,{x:r,y:e.from+18,"text-anchor":"middle"});for(let[r,o]of e.ticks)s(o,{x:n.from-8,y:r,dy:"0.35em","text-anchor":"end"});return s(n.label,{x:(n.from+n.to)/2,y:t-8,"text-anchor":"middle"}),s(e.label,{transform:`translate(14 ${(e.from+e.to)/2}) rotate(-90)`,"text-anchor":"middle"}),i}var uh=300,X_=30,rP=92,Z_=16,oP=5;function K_(n,e,{best:t,best_word:i,front:s},r){let a={axes:[...new Set(e.map(n.indexOf).filter(y=>y>=0))],opened:null,hovered:null,best:t,bestWord:i,front:s},l=S("div",{className:"titles"}),c=S("div",{className:"drawn"}),u=S("div",{className:"board"},l,c),h=S("div",{className:"scroll"},u),d=S("p",{className:"note",role:"status"}),f=S("p",{className:"note under"}," "),p=S("button",{type:"button"},`show all ${n.study.noun}s`);p.addEventListener("click",()=>{n.forget(),c.querySelector("[role=slider]")?.focus()});let x=()=>{cP(n,a,{board:u,titles:l,place:c,width:h.clientWidth}),hh(n,a,c)},g="Press a line to open its run. Move the two handles of an axis to select a range of values.",m=lP(n,a),_=`All ${n.study.noun}s as lines`,b=Xi(_,()=>qn(_),()=>sr([u,m],_,".handle")),v=S("div",{className:"head"},S("h2",{},_),b),E=S("section",{className:"lines"},v,S("p",{className:"note"},g),aP(n,a,x),h,m,S("div",{className:"choices"},p,d),f);pP(n,a,c,f,r),n.whenAsked(()=>{hh(n,a,c),J_(n,a,c),q_(n,d,p)}),q_(n,d,p);let A=0;return new ResizeObserver(()=>{h.clientWidth!==A&&(A=h.clientWidth,x())}).observe(h),{element:E,show(y){a.opened=y,hh(n,a,c)}}}function q_(n,e,t){let{points:i,noun:s}=n.study,r=Array.from({length:i},(l,c)=>c).filter(n.shown),o=r.filter(n.good).length,a=n.study.words.find(l=>l.good)?.word;e.textContent=`${r.length} of ${i} ${s}s lie within the selected ranges${a?`; ${a}: ${o}`:""}.`,t.hidden=n.asked.size===0}function aP(n,e,t){let i=n.columns.map((s,r)=>{let o=S("input",{type:"checkbox",checked:e.axes.includes(r)});return o.addEventListener("change",()=>{e.axes=n.columns.map((a,l)=>l).filter(a=>a===r?o.checked:e.axes.includes(a)),o.checked||n.ask(r,0,1),t()}),S("label",{},o,s.name)});return S("details",{},S("summary",{},"Axes"),S("fieldset",{className:"filter"},S("legend",{},"Show an axis of"),...i))}function lP(n,e){let t=(r,o)=>S("li",{},S("span",{className:`line ${r}`,"aria-hidden":"true"}),o),i=n.study.words.find(r=>r.good),s=[];return i&&s.push(t("good",i.word)),n.study.words.some(r=>!r.good)&&s.push(t("behind",i?`other ${n.study.noun}s`:`all ${n.study.noun}s`)),e.front.length&&s.push(t("front","Pareto front")),e.best!==null&&s.push(t("best",e.bestWord)),s.push(t("opened","open")),n.columns.some(r=>r.limits.length)&&s.push(S("li",{},S("span",{className:"bound","aria-hidden":"true"}),"range allowed by a limit")),S("ul",{className:"keys-of-lines"},...s)}function cP(n,e,{board:t,titles:i,place:s,width:r}){let o=e.axes.length,a=Math.max(r,o*rP);t.style.width=`${a}px`,i.replaceChildren(...e.axes.map(c=>uP(n.columns[c]))),i.style.gridTemplateColumns=`repeat(${o}, 1fr)`,e.x=c=>(c+.5)*a/o,e.y=c=>uh-X_-c*(uh-2*X_);let l=Lt("svg",{width:a,height:uh,viewBox:`0 0 ${a} ${uh}`,role:"img","aria-label":`${n.study.points} ${n.study.noun}s as lines over ${o} axes; the table below has them all`});l.append(Lt("g",{class:"layers"}));for(let[c,u]of e.axes.entries())l.append(...hP(n.columns[u],e.x(c),e.y));s.replaceChildren(l),J_(n,e,s)}function uP(n){let e=n.unit?` (${n.unit})`:"",t=n.aim?S("small",{},`${n.aim} is best`):"";return S("div",{},`${n.name}${e}`,t)}function hP({scale:n,limits:e},t,i){let s=[Lt("path",{class:"axis",d:`M${t} ${i(0)}V${i(1)}`})];for(let{kind:r,bound:o}of e){let a=Math.min(1,Math.max(0,n.share(o)));s.push(Lt("path",{class:"bound",d:`M${t} ${i(a)}V${i(r===">="?1:0)}`}))}for(let r of n.ticks){let o=i(n.share(r));s.push(Lt("path",{class:"axis",d:`M${t} ${o}h5`}),Lt("text",{class:"label",x:t+8,y:o,dy:"0.35em"},typeof r=="number"?ss(r):r))}return s}function J_(n,e,t){let i=t.contains(document.activeElement)?document.activeElement.dataset.handle:null;for(let s of t.querySelectorAll("[role=slider]"))s.remove();for(let[s,r]of e.axes.entries())for(let o of["least","most"]){let a=dP(n,e,t,r,o);a.style.left=`${e.x(s)}px`,t.append(a),a.dataset.handle===i&&a.focus()}}function dP(n,e,t,i,s){let r=n.columns[i],[o,a]=n.asked.get(i)??[0,1],l=s==="least"?o:a,c=r.scale.value(l),u=typeof c=="number"?`${ss(c)} ${r.unit}`.trim():String(c??""),h=S("div",{role:"slider",className:`handle ${s}`,tabIndex:0,"aria-orientation":"vertical","aria-label":`${s} ${r.name}`,"aria-valuemin":"0","aria-valuemax":"100","aria-valuenow":String(Math.round(100*l)),"aria-valuetext":u,title:`${s} ${r.name}: ${u}`});h.dataset.handle=`${i} ${s}`,h.dataset.keys="own",h.style.top=`${e.y(l)}px`;let d=x=>{let[g,m]=n.asked.get(i)??[0,1];s==="least"?n.ask(i,Math.min(Math.max(x,0),m),m):n.ask(i,g,Math.max(Math.min(x,1),g))},f=r.scale.words.length?1/r.scale.words.length:.02,p={ArrowUp:f,ArrowRight:f,ArrowDown:-f,ArrowLeft:-f,PageUp:5*f,PageDown:-5*f};return h.addEventListener("keydown",x=>{if(!(x.ctrlKey||x.metaKey||x.altKey)){if(x.key in p)d(l+p[x.key]);else if(x.key==="Home")d(0);else if(x.key==="End")d(1);else return;x.preventDefault()}}),h.addEventListener("pointerdown",x=>{x.preventDefault(),h.focus(),j_(x,g=>d(fp(e,t,g)))}),h}function j_(n,e,t=()=>{}){let i=o=>a=>a.pointerId===n.pointerId&&o(a),s=i(e),r=i(o=>{removeEventListener("pointermove",s),removeEventListener("pointerup",r),removeEventListener("pointercancel",r),t(o)});addEventListener("pointermove",s),addEventListener("pointerup",r),addEventListener("pointercancel",r)}function fp(n,e,t){let i=t.clientY-e.getBoundingClientRect().top;return Math.min(1,Math.max(0,(n.y(0)-i)/(n.y(0)-n.y(1))))}function fP(n,e,t){let i="",s=!1;for(let[r,o]of e.axes.entries()){let a=n.columns[o].values[t];a!==null&&(i+=`${s?"L":"M"}${e.x(r).toFixed(1)} ${e.y(n.columns[o].scale.share(a)).toFixed(1)}`),s=a!==null}return i}function hh(n,e,t){let i=t.querySelector(".layers");if(!i)return;let s=Array.from({length:n.study.points},(u,h)=>h),[r,o]=[s.filter(n.shown),s.filter(u=>!n.shown(u))],a=u=>u===null?[]:[u],l={out:o,behind:r.filter(u=>!n.good(u)),good:r.filter(n.good),front:e.front.filter(n.shown),best:a(e.best),opened:a(e.opened),hovered:a(e.hovered)},c=Object.entries(l).filter(([,u])=>u.length);i.replaceChildren(...c.map(([u,h])=>Lt("path",{class:`line ${u}`,d:h.map(d=>fP(n,e,d)).join("")})))}function pP(n,e,t,i,s){let r=o=>{o!==e.hovered&&(e.hovered=o,t.classList.toggle("pressable",o!==null),i.textContent=o===null?" ":`${n.nameOf(o)}${n.pointText(o)}: ${n.study.statuses[o]}`,hh(n,e,t))};t.addEventListener("pointermove",o=>{o.pointerType==="mouse"&&o.buttons===0&&r(Y_(n,e,t,o))}),t.addEventListener("pointerleave",()=>r(null)),t.addEventListener("pointerdown",o=>{if(o.button!==0||o.target.closest("[role=slider]"))return;let a=o.pointerType==="touch"?null:mP(e,t,o),l=fp(e,t,o),c=!1;j_(o,h=>{c||=Math.hypot(h.clientX-o.clientX,h.clientY-o.clientY)>oP;let d=fp(e,t,h);c&&a!==null&&n.ask(a,Math.min(l,d),Math.max(l,d))},h=>{let d=c||h.type==="pointercancel"?null:Y_(n,e,t,h);d!==null&&s(d)})})}function mP(n,e,t){let i=t.clientX-e.getBoundingClientRect().left,s=n.axes.findIndex((r,o)=>Math.abs(n.x(o)-i)<Z_);return s<0?null:n.axes[s]}function Y_(n,e,t,i){let s=t.getBoundingClientRect(),[r,o]=[i.clientX-s.left,i.clientY-s.top],a=e.axes.findLastIndex((p,x)=>e.x(x)<=r),[l,c]=[Math.max(0,a),Math.min(e.axes.length-1,a+1)],u=c>l?(r-e.x(l))/(e.x(c)-e.x(l)):0,h=(p,x)=>{let g=n.columns[e.axes[p]],m=g.values[x];return m===null?NaN:e.y(g.scale.share(m))},[d,f]=[null,Z_];for(let p=0;p<n.study.points;p++){if(!n.shown(p))continue;let[x,g]=[h(l,p),h(c,p)],m=x+u*(g-x),_=c>l?(g-x)/(e.x(c)-e.x(l)):0,b=Math.abs(o-m)/Math.hypot(1,_)-(n.good(p)?1:0);b<f&&([d,f]=[p,b])}return d}function Q_(n,e){let t=ch(n,e),i=n.factors.map(c=>({...c,limits:[],aim:""})),s=t.numbers.map(c=>({...c,key:c.name,name:c.title,log:!1,own:null})),r=[...i,...s].map(c=>({...c,scale:Xo(c,gP(c))})),o=new Map,a=[],l=([c,[u,h]],d)=>{let f=r[c].values[d];if(f===null)return!1;let p=r[c].scale.share(f);return p>=u-1e-9&&p<=h+1e-9};return{...t,columns:r,asked:o,indexOf:c=>r.findIndex(u=>u.key===c),shown:c=>[...o].every(u=>l(u,c)),good:c=>t.word(n.verdicts[c]).good,nameOf:c=>`${n.noun} ${c+1}: `,whenAsked:c=>a.push(c),ask(c,u,h){u<=0&&h>=1?o.delete(c):o.set(c,[u,h]);for(let d of a)d()},forget(){o.clear();for(let c of a)c()}}}function gP({limits:n,values:e}){let t=e.filter(r=>typeof r=="number"),[i,s]=[Math.min(...t),Math.max(...t)];return n.map(r=>r.bound).filter(r=>r>=i-(s-i)&&r<=s+(s-i))}var xP=12,[pp,Rs]=[200,76],ul=130;function ny(n,{marginals:e,pairs:t},i){let s=S("div",{className:"marginals"}),r=S("div",{className:"pairs"}),[o,a]=[e,t].map(h=>h.map(n.indexOf).filter(d=>d>=0)),l=()=>{s.replaceChildren(...o.map(h=>vP(n,h))),r.replaceChildren(...bP(n,a,i))};r.style.setProperty("--columns",Math.max(1,a.length-1)),n.whenAsked(l),l();let u=[ey("Single unknowns",s),S("p",{className:"note"},"Blue: samples that agree. Grey: all drawn samples. Each colour is scaled by its number of samples. Unknowns that the facts narrow most come first."),s];return a.length>1&&u.push(ey("Pairs of unknowns",r),S("p",{className:"note"},"Press a pair to enlarge it."),r),{element:S("section",{className:"agreeing"},...u)}}function ey(n,e){let t=Xi(n,()=>qn(n),()=>sr([e],n));return S("div",{className:"head"},S("h2",{},n),t)}var _P=n=>Array.from({length:n.study.points},(e,t)=>t),iy=n=>_P(n).filter(e=>!["placed","unbuilt"].includes(n.word(n.study.verdicts[e]).pattern));function yP(n,e,t){let i=e.words.length||xP,s=new Array(i).fill(0);for(let r of t)s[Math.min(i-1,Math.floor(e.share(n.values[r])*i))]+=1/t.length;return s}function vP(n,e){let t=n.columns[e],i=Xo(t),s=iy(n),r=s.filter(g=>n.good(g)&&n.shown(g)),[o,a]=[s,r].map(g=>yP(t,i,g)),l=Math.max(...o,...r.length?a:[0]),c=pp/o.length,u=(g,m)=>Lt("path",{class:m,d:g.map((_,b)=>`M${b*c+1} ${Rs}v${-_/l*(Rs-4)}h${c-2}V${Rs}z`).join("")}),h=g=>Lt("path",{class:"agree",d:`M0 ${Rs}${g.map((m,_)=>`V${Rs-m/l*(Rs-4)}H${(_+1)*c}`).join("")}V${Rs}`}),d=`${t.name}: ${ty(t,i,r)}`,f=Lt("svg",{viewBox:`0 0 ${pp} ${Rs}`,role:"img","aria-label":d,preserveAspectRatio:"none"},u(o,"all"),...r.length?[h(a)]:[],Lt("path",{class:"axis",d:`M0 ${Rs}H${pp}`})),p=i.words.length?i.words:[0,1].map(g=>ss(i.value(g))),x=t.unit?` (${t.unit})`:"";return S("figure",{},S("figcaption",{},`${t.name}${x}`),f,S("div",{className:"ends"},...p.map(g=>S("span",{},g))),S("small",{},ty(t,i,r)))}function ty(n,e,t){if(!t.length)return"no sample agrees";if(e.words.length)return e.words.map(r=>`${Math.round(100*t.filter(o=>n.values[o]===r).length/t.length)} % ${r}`).join(", ");let i=t.map(r=>n.values[r]).sort((r,o)=>r-o),s=r=>ss(i[Math.round(r*(i.length-1))]);return`middle half: ${s(.25)} to ${s(.75)}`}function bP(n,e,t){return e.slice(1).flatMap((i,s)=>e.slice(0,-1).map((r,o)=>o>s?S("span",{}):SP(n,r,i,t)))}function SP(n,e,t,i){let[s,r]=[e,t].map(f=>n.columns[f]),[o,a]=[s,r].map(f=>Xo(f)),l=(f,p)=>Lt("path",{class:p,d:f.map(x=>`M${(4+o.share(s.values[x])*(ul-8)).toFixed(1)} ${(ul-4-a.share(r.values[x])*(ul-8)).toFixed(1)}h0`).join("")}),c=iy(n),u=c.filter(f=>n.good(f)&&n.shown(f)),h=Lt("svg",{viewBox:`0 0 ${ul} ${ul}`,"aria-hidden":"true"},l(c.filter(f=>!u.includes(f)),"all"),l(u,"agree")),d=S("button",{type:"button","aria-label":`${r.name} over ${s.name}, large`},h,S("small",{},`${r.name} ↑, ${s.name} →`));return d.addEventListener("click",()=>i(e,t)),d}var[sy,mp]=[600,420],dh={left:76,right:14,top:12,bottom:52},ry=60,oy={ArrowLeft:-1,ArrowUp:-1,ArrowRight:1,ArrowDown:1};function fh(n,e,t){let{columns:i,study:s}=n,{quantity:r}=e,o=Array.from({length:s.points},(m,_)=>_),a=n.scaleOf(r),l=dp(i[e.x].values,i[e.x],dh.left,sy-dh.right,e.cells?.across),c=e.y===null?r.values??o.map(()=>0):i[e.y].values,u=e.y===null?{name:r.title,unit:r.unit}:i[e.y],h=dp(c,u,mp-dh.bottom,dh.top,e.cells?.upwards),d=`${r.title} of ${s.points} ${s.noun}s; arrows move between them, enter opens one`,f=Lt("svg",{viewBox:`0 0 ${sy} ${mp}`,class:["scatter",o.length>ry&&"many",e.ordered&&"judged"].filter(Boolean).join(" "),role:"listbox","aria-label":d});e.cells&&f.append(...AP(e.cells,l,h)),f.append(...$_(l,h,mp),...ly(i[e.x],l,h,!0),...e.y===null?[]:ly(i[e.y],h,l,!1));let p=o.map(m=>[l.place(m),h.place(m)]);e.joined&&f.append(EP(e.front,p,i[e.x].aim));let x=o.length>ry?6:8,g=o.map(m=>wP(n,e,a,m,p[m],x));return f.append(...(e.ordered?MP(n,e,o):o).map(m=>g[m])),(g[e.current??0]??g[0])?.setAttribute("tabindex","0"),TP(f,g,e.ordered?[...o].sort((m,_)=>p[m][0]-p[_][0]):o,t),{element:S("div",{className:"scroll"},f),points:o}}function MP(n,e,t){let i=s=>(n.shown(s)?0:1e6)+(e.best===s?-1:n.study.verdicts[s]);return[...t].sort((s,r)=>i(r)-i(s))}function wP(n,e,t,i,[s,r],o){let{quantity:a}=e,l=a.values?.[i]??null,c=`${n.nameOf(i)}${n.pointText(i)}: ${n.valueText(a,i)}`,u=Lt("g",{role:"option",tabindex:"-1","aria-label":c,"aria-selected":String(e.opened===i),"data-point":i,transform:`translate(${s.toFixed(1)} ${r.toFixed(1)})`},Lt("title",{},c)),{sign:h,pattern:d}=l===null?n.word(a.reasons[i]):{};return h&&u.setAttribute("class",`what ${d}`),n.shown(i)||u.classList.add("out"),e.front?.includes(i)&&u.append(Lt("circle",{r:o+3,class:"front"})),u.append(Lt("circle",{r:o,class:l===null?"missing":"found",fill:l===null?"transparent":t.colour(l).face})),h&&u.append(Lt("text",{"text-anchor":"middle",dy:"0.36em"},h)),e.best===i&&u.append(Lt("text",{class:"best","text-anchor":"middle",dy:-o-6},e.bestWord)),u}function AP(n,e,t){let[i,s]=[ay(n.across.map(e.at)),ay(n.upwards.map(t.at))];return n.works.flatMap((r,o)=>r.map((a,l)=>Lt("rect",{class:a?"map-works":"map-fails",x:i[o],width:i[o+1]-i[o],y:s[l+1],height:s[l]-s[l+1]})))}function ay(n){let e=n.slice(1).map((s,r)=>(s+n[r])/2),[t,i]=[n[0],n.at(-1)];return[t,...e,i]}function ly(n,e,t,i){let s=(a,l)=>Lt("path",{class:l,d:i?`M${a} ${t.from}V${t.to}`:`M${t.from} ${a}H${t.to}`}),r=a=>a>=Math.min(e.from,e.to)&&a<=Math.max(e.from,e.to),o=[];typeof n.own=="number"&&r(e.at(n.own))&&o.push(s(e.at(n.own),"own"));for(let{kind:a,bound:l}of n.limits??[]){let c=e.at(l);if(!r(c))continue;let u=a===">="?e.from:e.to,[h,d]=[Math.min(c,u),Math.abs(c-u)],f=i?{x:h,width:d,y:t.to,height:t.from-t.to}:{y:h,height:d,x:t.from,width:t.to-t.from};o.push(Lt("rect",{class:"beyond",...f}),s(c,"limit"))}return o}function EP(n,e,t){let i=n.map(r=>e[r]).sort((r,o)=>r[0]-o[0]),s=([r,o])=>t==="least"?`H${r.toFixed(1)}V${o.toFixed(1)}`:`V${o.toFixed(1)}H${r.toFixed(1)}`;return Lt("path",{class:"front",d:i.map((r,o)=>o?s(r):`M${r.join(" ")}`).join("")})}function TP(n,e,t,i){let s=r=>r.target.closest("[data-point]");n.addEventListener("click",r=>{s(r)&&i(Number(s(r).dataset.point))}),n.addEventListener("focusin",r=>{for(let o of e)o.setAttribute("tabindex",o===r.target?"0":"-1")}),n.addEventListener("keydown",r=>{let o=s(r);if(!o||r.ctrlKey||r.metaKey||r.altKey)return;let a=Number(o.dataset.point);if(r.key==="Enter"||r.key===" ")i(a);else if(r.key in oy)e[t[t.indexOf(a)+oy[r.key]]]?.focus();else return;r.preventDefault()})}function cy(n,{plane:e,front:t,best:i,best_word:s,joined:r},o){let{quantities:a}=n.study,[l,c]=[e.x,e.y].map(n.indexOf),[u,h]=[l,c],d={quantity:a[0],x:l,y:c,current:i??0,opened:null,front:t,best:i,bestWord:s,ordered:!0},f=S("div",{className:"map-place"}),p=S("div",{className:"map-legend"}),x=()=>{let C=d.x===u&&d.y===h;d.cells=C?e.cells:void 0,d.joined=r&&new Set([d.x,d.y,u,h]).size===2;let D=fh(n,d,g);f.replaceChildren(D.element),p.replaceChildren(...CP(n,d))},g=C=>{m(C),o(C)};function m(C){d.current=d.opened=C;let D=f.contains(document.activeElement);x(),D&&f.querySelector(`[data-point="${C}"]`)?.focus()}let _=n.columns.map((C,D)=>[D,C.name]),b={across:v("across",_,()=>d.x,C=>A("x","y",C)),upwards:v("upwards",_,()=>d.y,C=>A("y","x",C)),show:v("show",a.map((C,D)=>[D,C.title]),()=>a.indexOf(d.quantity),C=>{d.quantity=a[C]})};function v(C,D,k,N){let B=S("select",{},...D.map(([H,se])=>S("option",{value:String(H)},se)));B.value=String(k()),B.addEventListener("change",()=>{N(Number(B.value)),E(),x()});let $=S("label",{},`${C} `,B);return $.dataset.name=C,{element:$,fill:()=>{B.value=String(k())}}}let E=()=>Object.values(b).forEach(C=>C.fill());function A(C,D,k){d[D]===k&&(d[D]=d[C]),d[C]=k}let y=()=>[d.y,d.x].map(C=>n.columns[C].name).join(" over "),M=Xi(e.title,()=>qn(y()),()=>sr([f,p],y())),I=S("div",{className:"head"},S("h2",{},e.title),M),L=S("section",{className:"map"},I,S("div",{className:"choices"},...Object.values(b).map(C=>C.element)),f,p);return n.whenAsked(x),x(),{element:L,show:m,over(C,D){[d.x,d.y]=[C,D],E(),x()}}}function CP(n,{quantity:e,front:t,cells:i,x:s,y:r}){let o=lh(n,e),a=e.values?e.reasons:n.study.verdicts,l=n.study.words.flatMap((u,h)=>{let d=a.filter((f,p)=>f===h&&n.shown(p)).length;return d?[S("li",{},$o(u),`${u.word} (${d})`)]:[]});t.length&&l.push(S("li",{},S("span",{className:"ring","aria-hidden":"true"}),"Pareto front"));let c=[s,r].map(u=>n.columns[u]);if(c.some(u=>typeof u.own=="number")&&l.push(S("li",{},S("span",{className:"dashes","aria-hidden":"true"}),"as designed")),c.some(u=>u.limits.length)&&l.push(S("li",{},S("span",{className:"shade","aria-hidden":"true"}),"beyond a limit")),i)for(let u of["works","fails"])l.push(S("li",{},S("span",{className:`map-${u}`,"aria-hidden":"true"}),`${u} if only these two deviate`));return l.length&&o.push(S("ul",{},...l)),o}var RP=2e4,PP=16,IP=16,LP=12,uy={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function fy(n,e){let{quantities:t,sampled:i}=n.study,s=n.study.axes.filter(_=>n.sizes[_]>1),[r,o]=s.length>1?s:NP(n.study.factors[s[0]])?[s[0],null]:[null,s[0]??0],a={quantity:t[0],x:o,y:r,fixed:[...n.study.cuts],current:null,opened:null},l=S("div",{className:"map-place"}),c=S("div",{className:"map-legend"}),u=S("p",{className:"note"}),h=()=>{let _=a.y===null&&a.quantity.values&&n.sizes.every((v,E)=>v===1||E===a.x),b=i||_?fh(n,a,d):UP(n,a,d);l.replaceChildren(b.element),c.replaceChildren(...BP(n,a.quantity,b.points)),u.textContent=zP(n,a.quantity,b.points)},d=_=>{a.current=a.opened=_,DP(l,_),e(_,a.quantity)},f=OP(n,a,s,h),x=Xi("the map",()=>qn(a.quantity.title),()=>sr([l,c],my(n,a).split(";")[0])),g=S("div",{className:"head"},S("h2",{},"Map"),x),m=S("section",{className:"map"},g,f.element,l,c,u);return h(),{element:m,show(_){a.current=a.opened=_,i||(a.fixed=n.placesOf(_)),f.fill(),h()}}}function NP(n){return n?.values.some(e=>typeof e=="string"&&e.length>LP)??!1}function DP(n,e){for(let t of n.querySelectorAll("[data-point]")){let i=Number(t.dataset.point)===e;t.setAttribute("aria-selected",String(i)),t.tabIndex=i?0:-1}}function OP(n,e,t,i){let{factors:s,quantities:r,sampled:o}=n.study,a=S("div",{className:"choices"}),l=(h,d,f,p)=>{let x=S("select",{},...d.map(([g,m])=>S("option",{value:String(g)},m)));return x.value=String(f),x.addEventListener("change",()=>{p(Number(x.value)),u(),i(),[...a.querySelectorAll("label")].find(g=>g.dataset.name===h)?.querySelector("select").focus()}),S("label",{},`${h} `,x)},c=(h,d)=>f=>{e[d]===f&&(e[d]=e[h]),e[h]=f};function u(){let h=[l("show",r.map((d,f)=>[f,d.title]),r.indexOf(e.quantity),d=>{e.quantity=r[d]})];if(t.length>2){let d=t.map(f=>[f,s[f].name]);h.push(l("across",d,e.x,c("x","y")),l("upwards",d,e.y,c("y","x")))}for(let d of t.filter(f=>!o&&f!==e.x&&f!==e.y)){let f=s[d].texts.map((p,x)=>[x,s[d].unit?`${p} ${s[d].unit}`:p]);h.push(l(s[d].name,f,e.fixed[d],p=>{e.fixed[d]=p}))}for(let d of h)d.dataset.name=d.firstChild.textContent.trim();a.replaceChildren(...h)}return u(),{element:a,fill:u}}function UP(n,e,t){let{factors:i}=n.study,[s,r]=[e.x,e.y].map(m=>m===null?1:n.sizes[m]),o=e.x===null;if(s*r>RP)return{element:S("p",{className:"note"},"This map has too many cells for a page; see the figures of the study."),points:[]};let a=n.scaleOf(e.quantity),l=s<=PP,c=(m,_)=>n.pointAt(e.fixed.map((b,v)=>v===e.x?m:v===e.y?_:b)),u=new Map,h=[],d=[];for(let m=0;m<r;m++){let _=o?m:r-1-m,b=e.y===null?"":o?i[e.y].texts[_]:dy(i[e.y],_),v=S("tr",{},S("th",{scope:"row"},b));for(let E=0;E<s;E++){let A=c(E,_),y=S("td",{tabIndex:-1,role:"gridcell"});kP(y,n,e,a,A,l),u.set(`${E} ${_}`,y),d.push(A),v.append(y)}h.push(v)}if(!o){let m=i[e.x].texts.map((_,b)=>S("th",{scope:"col"},dy(i[e.x],b)));h.push(S("tr",{className:"feet"},S("td"),...m))}let f=S("table",{role:"grid",className:o?"grid list":l?"grid":"grid small","aria-label":my(n,e)},S("tbody",{},...h));f.style.setProperty("--columns",s),f.style.setProperty("--rows",r);let p=[...u.values()].find(m=>Number(m.dataset.point)===e.current)??u.get("0 0");p.tabIndex=0,FP(f,u,t,o);let x=S("div",{className:"upwards"},e.y===null||o?"":hy(i[e.y])),g=S("div",{className:"across"},o?"":hy(i[e.x]));return{element:S("div",{className:r<6?"axes low":"axes"},x,S("div",{},S("div",{className:"scroll"},f),g)),points:d}}function kP(n,e,t,i,s,r){let{quantity:o}=t,a=o.values?.[s]??null;n.dataset.point=s,n.setAttribute("aria-selected",String(t.opened===s));let l=`${e.pointText(s)}: ${o.values?`${o.title} `:""}${e.valueText(o,s)}`;if(n.setAttribute("aria-label",l),n.title=l,a===null){let{sign:h,pattern:d}=e.word(o.reasons[s]);n.className=`what ${d}`,n.append(S("span",{},r?h:""));return}let{face:c,ink:u}=i.colour(a);n.style.background=c,n.style.color=u,n.textContent=r?i.text(a):""}function FP(n,e,t,i){let s=new Map([...e].map(([r,o])=>[o,r.split(" ").map(Number)]));n.addEventListener("click",r=>{let o=r.target.closest("[data-point]");o&&t(Number(o.dataset.point))}),n.addEventListener("keydown",r=>{let o=r.target.closest("[data-point]");if(!o||r.ctrlKey||r.metaKey||r.altKey)return;let[a,l]=s.get(o),[c,u]=uy[r.key]??[0,0],h=i?-u:u,d=Math.max(...[...s.values()].map(([p])=>p)),f={Home:`0 ${l}`,End:`${d} ${l}`}[r.key]??`${a+c} ${l+h}`;if(r.key==="Enter"||r.key===" ")t(Number(o.dataset.point));else{if(!(r.key in uy)&&r.key!=="Home"&&r.key!=="End")return;e.has(f)&&(o.tabIndex=-1,e.get(f).tabIndex=0,e.get(f).focus())}r.preventDefault()})}function BP(n,e,t){let i=lh(n,e),s=[...py(e,t)].map(([r,o])=>{let a=n.word(r);return S("li",{},$o(a),`${a.word} (${o})`)});return s.length&&i.push(S("ul",{},...s)),i}function py(n,e){let t=new Map;for(let i of e){let s=n.reasons[i];s!==null&&t.set(s,(t.get(s)??0)+1)}return new Map([...t].sort(([i],[s])=>i-s))}function zP(n,e,t){let i=t.filter(u=>(e.values?.[u]??null)!==null),s=[...py(e,t)].map(([u,h])=>`${h} ${n.word(u).word}`),r=`${e.title[0].toUpperCase()}${e.title.slice(1)}`,o=`${n.study.noun}s`;if(!i.length)return`${r} of ${t.length} ${o}: ${s.join(", ")||"none"}.`;let a=s.length?` Other ${o}: ${s.join(", ")}.`:"",[l,c]=[Math.min,Math.max].map(u=>VP(n,e,i,u));return`${r}, known for ${i.length} of ${t.length} ${o}: from ${l} to ${c}.${a}`}function VP(n,e,t,i){let s=t.map(a=>e.values[a]).reduce((a,l)=>i(a,l)),r=t.filter(a=>e.values[a]===s),o=r.length>1?`${r.length} ${n.study.noun}s`:n.pointText(r[0]);return`${n.valueText(e,r[0])} (${o})`}function my(n,e){let{factors:t}=n.study,i=e.y===null||e.x===null?t[e.x??e.y].name:`${t[e.x].name} across and ${t[e.y].name} upwards`;return`${e.quantity.title} over ${i}; arrows move between cells, enter opens one`}function hy(n){return n.unit?`${n.name} (${n.unit})`:n.name}function dy(n,e){let t=Math.ceil(n.texts.length/IP);return e%t?"":n.texts[e]}var gy=2,GP=20;function yy(n){let e=document.getElementById("live")?.textContent??null,t=e&&JSON.parse(e),i=S("div",{className:"answer"}),s=S("p",{className:"outcome",role:"status"}),r=S("div"),o=S("div"),a=null,l=!1,c=0,u=Promise.resolve(),h=0;function d(_,b){if(h+=1,c=_,!t)return[];if(!xu())return b?[]:[S("p",{className:"note"},`It cannot be simulated here either: ${t.refused}.`)];if(a)x(_);else if(!l){let v=S("button",{type:"button",className:"try"},b?"Try it and refine here":"Simulate it here"),E=S("p",{className:"note"});v.addEventListener("click",()=>f(v,E)),o.replaceChildren(S("div",{className:"offer"},v,E))}return[o]}async function f(_,b){l=_.disabled=!0,b.textContent="Starting the simulator …";try{a=await Do(Jn(t.bench.clips[0]),t.bench,e,Po),o.replaceChildren(i),i.replaceChildren(a.element),a.begin(),x(c)}catch(v){b.textContent=`It cannot be simulated here: ${v.message}.`}}async function p(_,b){if(await u.catch(()=>null),b!==h)return null;u=a.engine.ask({act:"answer",values:_,search:t.search});let{answer:v}=await u;return b===h?v:null}async function x(_){let b=++h,v=S("button",{type:"button"},"Refine here");v.addEventListener("click",()=>m(_)),r.replaceChildren(),i.replaceChildren(s,...vy(n,t).length?[v]:[],r,a.element),s.textContent="Simulating …",a.sliders.set(t.points[_]);let E=await p(t.points[_],b);E&&(s.textContent=`${Ot(n.pointText(_))}: ${_y(t,E)}.`,g(_))}function g(_){a.sliders.set(t.points[_]),a.engine.send({act:"restart",through:!1})}async function m(_){let b=++h,v=WP(n,t,_),E=new Map,A=S("p",{className:"note",role:"status"}),y=v[1].values.map(D=>v[0].values.map(k=>HP(v,k,D))).reverse(),M=y.map((D,k)=>S("tr",{},S("th",{scope:"row"},xy(v[1],v[1].values.length-1-k)),...D.map(({cell:N})=>N))),I=S("tr",{className:"feet"},S("td"),...v[0].values.map((D,k)=>S("th",{scope:"col"},xy(v[0],k)))),L=S("table",{className:"grid"},S("caption",{},XP(v,n.study.sampled)),S("tbody",{},...M,I));r.replaceChildren(S("div",{className:"table",tabIndex:0,role:"group","aria-label":"finer map"},L),A);let C=y.flat();for(let[D,{cell:k,values:N,where:B}]of C.entries()){A.textContent=`${D} of ${C.length} points simulated`;let $=await p({...t.points[_],...N},b);if(!$)return;let{sign:H,pattern:se}=n.study.words.find(({word:Y})=>Y===$.word)??n.study.other;k.className=`what ${se}`,k.replaceChildren(S("span",{},H)),k.title=`${B}: ${_y(t,$)}`,k.setAttribute("aria-label",k.title),E.set($.word,H)}A.textContent=[...E].map(([D,k])=>`${k} ${D}`).join(" · "),g(_)}return{offer:d,get panel(){return a}}}function HP(n,e,t){let i={[n[0].key]:e};n[1].key&&(i[n[1].key]=t);let s=n.filter(({key:r})=>r).map(r=>`${r.name} ${bt(r.factor*i[r.key])} ${r.unit}`).join(", ");return{cell:S("td",{"aria-label":`${s}: not simulated yet`}),values:i,where:s}}function vy(n,e){let t=i=>e.knobs.some(({key:s})=>s===n.study.factors[i].key);return n.study.axes.filter(i=>n.sizes[i]>1&&t(i))}function WP(n,e,t){let i=vy(n,e),[s,r]=i.length>1?i:[null,i[0]??0],o=a=>{if(a===null)return{key:"",name:"",unit:"",factor:1,values:[0]};let{key:l,name:c}=n.study.factors[a],u=e.knobs.find(g=>g.key===l);if(n.study.sampled)return{key:l,name:c,unit:u.unit,factor:u.factor,values:$P(e.points.map(g=>g[l]),t)};let h=n.placesOf(t),d=g=>e.points[n.pointAt(h.map((m,_)=>_===a?g:m))][l],[f,p]=[Math.max(0,h[a]-1),Math.min(n.sizes[a]-1,h[a]+1)],x=[];for(let g=f;g<p;g++)for(let m=0;m<gy;m++)x.push(d(g)+m/gy*(d(g+1)-d(g)));return{key:l,name:c,unit:u.unit,factor:u.factor,values:[...x,d(p)]}};return[o(r),o(s)]}function $P(n,e){let[t,i]=[Math.min(...n),Math.max(...n)],s=[-2,-1,0,1,2].map(r=>n[e]+r*(i-t)/GP);return[...new Set(s.map(r=>Math.min(i,Math.max(t,r))))].sort((r,o)=>r-o)}var xy=({key:n,factor:e,unit:t,values:i},s)=>n?`${bt(e*i[s])} ${t}`:"";function XP([n,e],t){return`${e.key?`${Ot(n.name)} across, ${e.name} upwards`:Ot(n.name)}, ${t?"around it":"at half the steps"}`}function _y(n,{status:e,least:t}){let s=(n.search?[n.search.first,n.search.second].filter(Boolean):[]).filter(({name:r})=>t[r]!==null&&t[r]!==void 0).map(({key:r,name:o,title:a})=>{let{factor:l,unit:c}=n.knobs.find(u=>u.key===r);return`${a} ${bt(l*t[o])} ${c}`});return[e,...s].join("; ")}function ph(n){let e=S("h2"),t=S("p",{className:"outcome",role:"status"}),i=S("table",{className:"numbers"}),s=S("section",{className:"facts",id:"point"},e,t,S("div",{className:"table"},i)),r=S("div",{className:"parts",role:"group","aria-label":`runs of this ${n.study.noun}`}),o=S("div"),a=S("div",{className:"more"}),l=S("section",{className:"run",id:"run","aria-label":"the run that is open"},r,o,a),c=S("section",{className:"run below","aria-label":"plots and numbers of the run that is open"}),u=yy(n),h={facts:s,element:l,below:c,point:null,playing:null,answers:u,open:p,show:m},d=null,f=nr();function p(b,{play:v=!1,transition:E=null}={}){h.point=b;let A=n.runsOf(b);e.textContent=Ot(`${n.study.noun} ${b+1}`),t.textContent=`${Ot(n.pointText(b))}: ${n.study.statuses[b]}.`,i.replaceChildren(S("caption",{},n.study.numbers??"Values in the table"),S("tbody",{},...JP(n,b))),r.replaceChildren(...A.length>1?A.map(x):A.map(I=>S("b",{},Ot(I.title))));let y=E===null?null:A.find(I=>I.transition===E),M=v?A.find(I=>I.failed):null;A.length?m(y??M??A[0],{play:v}):(g(),o.replaceChildren(S("p",{className:"note"},jP(n,b))),c.replaceChildren()),a.replaceChildren(...n.study.built[b]?u.offer(b,A.length>0):[])}function x(b){let v=S("button",{type:"button"},b.title);return v.dataset.part=b.part,v.addEventListener("click",()=>m(b,{play:!0})),v}function g(){h.playing?.dispose(),h.playing=null}function m(b,{play:v=!1}={}){g();for(let C of r.querySelectorAll("button"))C.setAttribute("aria-pressed",String(C.dataset.part===b.part));let E=d&&d!==b?d:null,A=E?[E,b]:[b],y={player:S("div"),plots:S("div"),readouts:A.map(()=>S("div"))},[M,I]=[QP,e2].map(C=>A.map((D,k)=>C(D,by(A,n)[k]))),L=b.advice?[S("p",{className:"note"},b.advice)]:[];o.replaceChildren(S("p",{},b.text),_(b),...L,y.player),c.replaceChildren(y.plots,...y.readouts,...M,...I),f.scale=n.largestSpan/b.play.clips[0].span_m,h.playing={run:b,beside:E,...qP(y,b,E,n,f)},No(c),v&&!matchMedia("(prefers-reduced-motion: reduce)").matches&&h.playing.clock.play()}function _(b){let E=S("button",{type:"button",className:"pin"},d?`unpin ${n.study.noun} ${d.point+1}`:"pin to compare with another");return E.addEventListener("click",()=>{d=d?null:b,m(b),o.querySelector(".pin").focus()}),E}return h}function qP(n,e,t,i,s){let r=t?[t,e]:[e],o=r.map((f,p)=>ZP(f,by(r,i)[p],i)),a=r.map((f,p)=>({...Jn(f.play.clips[0]),...t?{name:o[p]}:{}})),l=Oi(a,t?[KP(a)]:e.play.spans),c=r.map(f=>f.play.energy).reduce((f,p)=>p.largest_J>f.largest_J?p:f),u=t?`${Ot(a[0].name)} and ${a[1].name}, side by side with a common clock.`:e.play.text,h=rr(n.player,a,l,{...e.play,energy:c,text:u},s);t&&up(h.stage.cells,a,l,c);let d=cr(n.plots,t?YP(r,a):e.play.plots,a,l);n.plots.classList.toggle("paired",t!==null);for(let[f,p]of a.entries())or(n.readouts[f],p,l,c,f,t!==null);return{clips:a,clock:l,player:h,plots:d,dispose(){h.dispose(),d.dispose()}}}function YP(n,e){let t=n.map(({play:s},r)=>s.plots.map(o=>({...o,owner:e[r].name,sharing:`${o.title} ${o.unit}`,lines:o.lines.map(a=>({...a,clip:r}))})));return[...new Set(t.flat().map(s=>s.title))].flatMap(s=>t.flat().filter(r=>r.title===s))}function by(n,{study:e}){if(n.length===1)return[""];let t=new Set(n.map(i=>i.point)).size<n.length;return n.map(i=>`${e.noun} ${i.point+1}${t?`, ${i.title}`:""}`)}function ZP(n,e,t){let{factors:i}=t.study,s=t.placesOf(n.point).map((r,o)=>`${i[o].texts[r]} ${i[o].unit}`.trim());return`${e}: ${s.join(", ")}`}function KP(n){let e=n.map(s=>s.stages.find(r=>r.driven)?.start??s.start),[t,i]=[Math.min(...n.map((s,r)=>s.start-e[r])),Math.max(...n.map((s,r)=>s.end-e[r]))];return{name:"whole runs",label:"time since the first drive acts",start:t,end:i,origins:e,whole:!0}}function JP(n,e){return n.numbers.map(t=>S("tr",{},S("th",{scope:"row"},t.title),S("td",{},n.valueText(t,e))))}function jP(n,e){return n.study.built[e]?`${n.study.unkept??"This run was not kept, so it cannot be played here."} ${n.study.keeps}`:n.study.unbuilt}function QP(n,e){let t=S("div");return t.innerHTML=n.numbers,S("details",{},S("summary",{},`States of ${e||"this run"}`),t)}function e2(n,e){let t=[`forficula run ${n.folder}/design.toml`,`forficula film ${n.folder} --out film.mp4`];return S("details",{},S("summary",{},e?`Commands for ${e}`:"Commands"),S("p",{className:"note"},"In the folder of this page, these commands repeat the run and make a film of it:"),S("pre",{},S("code",{},t.join(`
`))))}function mh(n,e,t,i){let s=n?.querySelector("table");if(!s)return()=>{};let r=[...s.tBodies[0].rows],o=S("p",{className:"note",role:"status"}),a=t2(e,()=>{let u=a.shown(),h=0;for(let[d,f]of r.entries())f.hidden=!u.has(e.study.verdicts[d])||!e.shown(d),h+=f.hidden?0:1;o.textContent=`${h} of ${r.length} ${e.study.noun}s shown.`});for(let[u,h]of r.entries()){let d=S("button",{type:"button","aria-label":`open ${e.study.noun} ${u+1}`},h.cells[0].textContent);d.addEventListener("click",()=>i(u)),h.cells[0].replaceChildren(d)}let l=e.study.factors.length+1;for(let u of[s.tHead.rows[0],...r])u.cells[l].classList.add("words");i2(s,r,n2(e));let c=S("div",{className:"choices"},a.element,...t?[r2(t,e.study.file)]:[]);return s.closest(".table").before(c,o),a.changed(),a.changed}function t2(n,e){let t=new Map,i=n.study.words.flatMap((r,o)=>{if(!r.count)return[];let a=S("input",{type:"checkbox",checked:!0});return a.addEventListener("change",e),t.set(o,a),[S("label",{},a,$o(r),`${r.word} (${r.count})`)]});return{element:S("fieldset",{className:"filter"},S("legend",{},`Show ${n.study.noun}s that`),...i),changed:e,shown:()=>new Set([...t].filter(([,r])=>r.checked).map(([r])=>r))}}function n2(n){let{study:e}=n,t=e.statuses.map((r,o)=>o),i=e.factors.map((r,o)=>t.map(a=>r.values[n.placesOf(a)[o]])),s=n.numbers.map(r=>r.values);return[t,...i,e.statuses,...s]}function i2(n,e,t){let i=[...n.tHead.rows[0].cells];for(let[s,r]of i.entries()){let o=S("button",{type:"button"},...r.childNodes);r.replaceChildren(o),o.addEventListener("click",()=>{let a=r.getAttribute("aria-sort")==="ascending";for(let c of i)c.removeAttribute("aria-sort");r.setAttribute("aria-sort",a?"descending":"ascending");let l=e.map((c,u)=>u).sort((c,u)=>s2(t[s][c],t[s][u],a?-1:1)||c-u);n.tBodies[0].append(...l.map(c=>e[c]))})}i[0].setAttribute("aria-sort","ascending")}function s2(n,e,t){if(n===null||e===null)return(n===null)-(e===null);let i=typeof n=="number"?n-e:String(n).localeCompare(String(e),"en");return t*i}function r2(n,e){let t=S("button",{type:"button",className:"button"},`Download ${e}`);return t.addEventListener("click",()=>{let i=URL.createObjectURL(new Blob([n],{type:"text/csv;charset=utf-8"}));S("a",{href:i,download:e}).click(),setTimeout(()=>URL.revokeObjectURL(i),1e4)}),t}function Sy(n){let e=ch(n.study,n.runs),t=ph(e),i=(a,l=null)=>{t.open(a,{play:!0,transition:l}),gp(t)},s=fy(e,(a,l)=>i(a,l.transition)),r=n.runs.length?[[s.element,t.facts],[t.element]]:[[s.element],[t.facts,t.element]];document.getElementById("explorer").replaceChildren(S("div",{className:"explorer"},...r.map(a=>S("div",{},...a)),t.below)),mh(document.getElementById("points"),e,n.csv,a=>{s.show(a),i(a)});let o=o2(e,n.runs);return t.open(o),s.show(o),{model:e,map:s,panel:t,open:i}}function o2(n,e){let t=n.study.quantities.filter(o=>o.group==="torque"),i=o=>[n.study.verdicts[o],...t.map(a=>a.values[o]??1/0),o],s=(o,a)=>{let l=o.findIndex((c,u)=>c!==a[u]);return l>=0&&o[l]<a[l]};return e.map(o=>o.point).reduce((o,a)=>o===null||s(i(a),i(o))?a:o,null)??0}function gp({facts:n,element:e}){let{top:t}=e.getBoundingClientRect();if(t>=0&&t<.5*innerHeight)return;let i=n.getBoundingClientRect().left===e.getBoundingClientRect().left,s=matchMedia("(prefers-reduced-motion: reduce)").matches;(i?n:e).scrollIntoView({behavior:s?"auto":"smooth",block:"start"})}function My(n){let{views:e}=n,t=Q_(n.study,n.runs),i=ph(t),s=[],r=(g,m)=>{i.open(g,{play:m});for(let _ of s)_.show?.(g)},o=g=>{r(g,!0),gp(i)},a=K_(t,e.lines,e,o),l=t.columns.filter(g=>g.aim).length===2,c=cy(t,{...e,joined:l},o),u=e.pairs?.length?ny(t,e,h):null;s.push(a,c);function h(g,m){c.over(g,m),c.element.scrollIntoView({block:"start"})}let d=n.runs.length?[[c.element,i.facts],[i.element]]:[[c.element],[i.facts]],f=S("div",{className:"explorer"},...d.map(g=>S("div",{},...g)),i.below),p={lines:a.element,pairs:u?.element,plane:f};document.getElementById("explorer").replaceChildren(...e.order.map(g=>p[g]));let x=mh(document.getElementById("points"),t,n.csv,o);return t.whenAsked(x),n.study.points&&r(a2(t,n),!1),{model:t,panel:i,lines:a,plane:c,open:o}}function a2(n,{runs:e,views:t,study:i}){let{best:s}=t,r=e.map(o=>o.point);return s!==null&&r.includes(s)?s:r.find(o=>n.good(o))??r[0]??s??i.verdicts.findIndex((o,a)=>n.good(a)||a===i.points-1)}async function wy(n){let e=new Blob([qt(n,Uint8Array)]).stream(),t=await new Response(e.pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();function i({kind:s,start:r,shape:o,low:a,step:l}){let c=o.reduce((d,f)=>d*f,1);if(s==="f4")return new Float32Array(t,r,c);if(s==="f8")return new Float64Array(t,r,c);let u=new(s==="u2"?Uint16Array:Uint32Array)(t,r,c),h=l2(u,...o);return a?Float32Array.from(h,(d,f)=>a[f%o[1]]+l[f%o[1]]*d):h}return i}function l2(n,e,t){let i=n.constructor,s=new i(1),r=new i(n.length);for(let o=0;o<t;o++){s[0]=0;for(let a=0;a<e;a++)s[0]+=n[o*e+a],r[a*t+o]=s[0]}return r}var c2="M7 4.5v15l12-7.5z",u2="M7 5h3.5v14H7zM13.5 5H17v14h-3.5z",ur=180/Math.PI,gh=1,Ay=10,Ey=720;function Ry(n,e,t,i){let[s,r]=[n.lowest,n.highest].map(p=>p*ur),o=p2(n),a=f2(n,s,r,o),l=S("button",{type:"button",className:"play"}),c=S("input",{type:"range",min:s,max:r,step:"any","aria-label":"hinge angle"});c.dataset.keys="own";let u=S("p",{className:"time"}),h=p=>{e.pause(),e.seek(i(Math.min(r,Math.max(s,p))/ur))},d=()=>e.playing?e.pause():e.play(),f=a.map(({angle:p,name:x})=>{let g=S("button",{type:"button"},S("b",{},Ty(p)),` ${x}`);return g.addEventListener("click",()=>h(p)),g});return c.addEventListener("input",()=>h(Number(c.value))),d2(c,()=>t(e.time)*ur,h,d),l.addEventListener("click",d),e.onChange(()=>{let p=t(e.time)*ur;c.value=p,u.textContent=`${Ty(p,1)}${Cy(n,p)}`,c.setAttribute("aria-valuetext",`${Nn(p,1)} degrees${Cy(n,p)}`);for(let[g,m]of a.entries())f[g].setAttribute("aria-pressed",String(Math.abs(m.angle-p)<.005));let x=e.playing?"pause":"play: fold from stop to stop";l.getAttribute("aria-label")!==x&&l.replaceChildren(ml(e.playing?u2:c2)),l.setAttribute("aria-label",x)}),S("div",{className:"transport"},S("div",{className:"line"},l,h2(c,s,r,o,a)),S("div",{className:"choices"},u,S("div",{className:"states"},...f)))}function h2(n,e,t,i,s){let r=S("div",{className:"bands","aria-hidden":"true"}),o=S("div",{className:"ticks","aria-hidden":"true"}),a=l=>`${100*l/(t-e)}%`;for(let[l,c]of i){let u=S("span",{className:"band"});Object.assign(u.style,{left:a(l-e),width:a(c-l)}),r.append(u)}for(let{angle:l,stop:c}of s){let u=S("span",{className:c?"tick stop":"tick"});u.style.left=a(l-e),o.append(u)}return S("div",{className:"track"},r,n,o)}function d2(n,e,t,i){let s={ArrowLeft:-gh,ArrowDown:-gh,ArrowRight:gh,ArrowUp:gh},r={PageDown:-Ay,PageUp:Ay,Home:-1/0,End:1/0};n.addEventListener("keydown",o=>{if(!(o.shiftKey||o.ctrlKey||o.metaKey||o.altKey)){if(o.key===" ")i();else if(o.key in s)t(Math.round(e()+s[o.key]));else if(o.key in r)t(e()+r[o.key]);else return;o.preventDefault()}})}var Ty=(n,e=null)=>`${e===null?Nn(n,Number.isInteger(Number(n.toFixed(3)))?0:1):Nn(n,e)}°`;function f2(n,e,t,i){if(n.folds){let a=[{angle:e,name:"flat",stop:!0},{angle:t,name:"folded",stop:!0}];return t>e?a:a.slice(0,1)}let s=a=>[...new Set(n.joints.map(l=>Number((l[a]*ur).toFixed(6))))],r=[...s("lower").map(a=>({angle:a,name:"folding stop",stop:!0})),...i.flatMap(([a,l])=>[a,l].map(c=>({angle:c,name:"all straps slack"}))),...e<0&&t>0?[{angle:0,name:"flat"}]:[],...s("upper").map(a=>({angle:a,name:t>0?"overbend stop":"stop, flat",stop:!0}))],o=a=>Math.abs(a-e)<1e-6||Math.abs(a-t)<1e-6;return r.filter(a=>a.stop||a.name==="flat"||!o(a.angle)).sort((a,l)=>a.angle-l.angle)}function p2(n){let e=a=>Py(n,a).every(({longer:l})=>l<0),[t,i]=[n.lowest*ur,n.highest*ur],s=(a,l)=>{let c=e(a);for(let u=0;u<40;u++){let h=(a+l)/2;e(h)===c?a=h:l=h}return l},r=[];if(!n.straps.length)return r;let o=e(t)?null:t;for(let a=1;a<=Ey;a++){let[l,c]=[a-1,a].map(u=>t+(i-t)*u/Ey);e(l)!==e(c)&&(o===null?o=s(l,c):(r.push([o,s(l,c)]),o=null))}return o!==null&&r.push([o,i]),r}function Py(n,e){let t=n.turn(n.anglesTogether(e/ur));return n.straps.flatMap(i=>n.strapStretches(i,t).map(s=>({longer:s,rest:i.rest})))}function Cy(n,e){let t=Py(n,e);if(!t.length)return"";let i=t.filter(({longer:a})=>a<0).length,s=Math.max(...t.map(({longer:a})=>a));if(i===t.length)return`, straps slack by ${Nn(-1e3*s,1)} mm or more`;let r=Math.max(...t.map(({longer:a,rest:l})=>a/l)),o=`stretched by up to ${Nn(1e3*s,1)} mm (${Nn(100*r,1)} %)`;return i?`, ${i} of ${t.length} straps slack, others ${o}`:`, straps ${o}`}function Iy(n){let e=S("input",{type:"range",min:0,max:100,step:1,value:0});return e.dataset.keys="own",e.addEventListener("input",()=>n(Number(e.value)/100)),e.setAttribute("aria-valuetext","together"),e.addEventListener("input",()=>{e.setAttribute("aria-valuetext",e.value==="0"?"together":`${e.value} % apart`)}),S("label",{className:"slide"},"take apart ",e)}function Ly(n,e,t){let i=n.map((s,r)=>{let o=S("input",{type:"checkbox",checked:!0});o.dataset.keys="own",o.addEventListener("change",()=>t(r,o.checked));let a=S("span",{className:"swatch panel","aria-hidden":"true"});return a.style.background=s.colour,S("label",{},o,a,`${s.name}${e[r]>1?`, ${e[r]}`:""}`)});return S("fieldset",{className:"kinds"},S("legend",{},"show"),...i)}function xp(n,e,t){let i=S("select",{},...e.map((s,r)=>S("option",{value:String(r)},s)));return i.addEventListener("change",()=>t(Number(i.value))),S("label",{},`${n} `,i)}var xh=28,Ny=24;function Dy(n,e){return n.ends.map(t=>{let[i,s]=t.map((r,o)=>new G(...r).applyMatrix4(qo(e,n.bodies[o])));return i.distanceTo(s)-n.rest})}var m2=new at,qo=(n,e)=>e<0?m2:n[e];function _p(n,e,t,i,s){let r=new G(...n.axis).transformDirection(qo(e,n.bodies[0])),o=new G(...n.up).transformDirection(qo(e,n.bodies[0]));return n.ends.map(a=>{let l=a.map((_,b)=>new G(..._).applyMatrix4(qo(e,n.bodies[b])).add(i)),c=l[1].clone().sub(l[0]),u=c.dot(r);c.addScaledVector(r,-u);let h=c.length(),d=h>1e-9?c.divideScalar(h):new G().crossVectors(r,o),f=new G().crossVectors(r,d).multiplyScalar(t),x=n.rest>Math.hypot(h,u)?Math.sqrt(n.rest**2-u**2):h,g=g2(s,x>1e-9?h/x:1);return{points:g.map(([_,b],v)=>l[0].clone().addScaledVector(d,_*x).addScaledVector(f,b*x).addScaledVector(r,u*v/(g.length-1))),wide:r,ends:l}})}function g2({values:n,shape:e},t){let[i,s]=e,r=Math.sqrt(Math.max(0,1-t))*(i-1),o=Math.min(i-2,Math.floor(r)),a=Math.min(1,r-o),l=(d,f,p)=>n[(d*s+f)*2+p],c=(d,f)=>l(o,d,f)+a*(l(o+1,d,f)-l(o,d,f)),u=c(s-1,0),h=u>1e-6?t/u:1;return Array.from({length:s},(d,f)=>[h*c(f,0),c(f,1)])}function Oy(n,e,t){let i={triangles:[],edges:[]};for(let{points:s,wide:r,ends:o}of e){let a=r.clone().multiplyScalar(n.width/2),l=s.map((c,u)=>{let d=s[Math.min(u+1,s.length-1)].clone().sub(s[Math.max(u-1,0)]).cross(r).setLength(n.thickness/2);return[[-1,-1],[1,-1],[1,1],[-1,1]].map(([f,p])=>c.clone().addScaledVector(a,f).addScaledVector(d,p))});ky(i,l,[0,1,2,3]);for(let[c,u]of o.entries()){let h=new G(...n.across[c]).transformDirection(qo(t,n.bodies[c]));_2(i,u,h,n.width,n.eye/2,n.peg/2)}}return i}function yp(n,e,t){let i=n.places.map(x=>new G(...x).add(t)),[s,r,o,a]=i,l=qo(e,n.body),[c,u]=[o,a].map(x=>x.clone().sub(t).applyMatrix4(l).add(t)),h=r.clone().sub(s).normalize(),d=u.clone().sub(c).normalize(),f=r.distanceTo(o),p=[s];for(let x=0;x<=Ny;x++)p.push(x2(r,h,c,d,f,x/Ny));return[...p,u]}function x2(n,e,t,i,s,r){let[o,a]=[1-r,r];return n.clone().multiplyScalar(o*o*(1+2*a)).addScaledVector(t,a*a*(1+2*o)).addScaledVector(e,s*o*o*a).addScaledVector(i,-s*a*a*o)}function Uy(n,e){let t={triangles:[],edges:[]},i=n[1].clone().sub(n[0]).normalize(),s=new G(Math.abs(i.z)<.9?0:1,0,Math.abs(i.z)<.9?1:0),r=n.map((o,a)=>{let l=n[Math.min(a+1,n.length-1)].clone().sub(n[Math.max(a-1,0)]).normalize();s=s.clone().addScaledVector(l,-s.dot(l)).normalize();let c=new G().crossVectors(l,s);return Array.from({length:xh},(u,h)=>{let d=2*Math.PI*h/xh;return o.clone().addScaledVector(s,Math.cos(d)*e/2).addScaledVector(c,Math.sin(d)*e/2)})});return ky(t,r,[]),t}function ky({triangles:n,edges:e},t,i){let s=t[0].length;for(let r=1;r<t.length;r++){let[o,a]=[t[r-1],t[r]];for(let l=0;l<s;l++){let c=(l+1)%s;n.push(o[l],o[c],a[c],o[l],a[c],a[l]),i.includes(l)&&e.push(o[l],a[l])}}for(let r of[t[0],t.at(-1)])for(let o=1;o<s-1;o++)n.push(r[0],r[o],r[o+1])}function _2({triangles:n,edges:e},t,i,s,r,o){let a=new G(Math.abs(i.z)<.9?0:1,0,Math.abs(i.z)<.9?1:0);a.addScaledVector(i,-a.dot(i)).normalize();let l=new G().crossVectors(i,a),c=(u,h,d)=>t.clone().addScaledVector(i,d*s/2).addScaledVector(a,h*Math.cos(u)).addScaledVector(l,h*Math.sin(u));for(let u=0;u<xh;u++){let[h,d]=[u,u+1].map(p=>2*Math.PI*p/xh),f=(p,x,g,m)=>n.push(p,x,g,p,g,m);f(c(h,r,-1),c(d,r,-1),c(d,r,1),c(h,r,1));for(let p of[-1,1])f(c(h,o,p),c(d,o,p),c(d,r,p),c(h,r,p)),e.push(c(h,r,p),c(d,r,p))}}function Fy(n,e){let t=e.map(({origin:a,axis:l})=>[new G(...a),new G(...l)]),i=n.map((a,l)=>e.flatMap((c,u)=>c.body===l?[u]:[])),s=n.map(()=>new at),r=new at,o=new G;return function(l){for(let[c,u]of n.entries()){let h=s[c];u<0?h.identity():h.copy(s[u]);for(let d of i[c]){let[f,p]=t[d];r.makeRotationAxis(p,l[d]-e[d].built),o.copy(f).applyMatrix4(r),r.setPosition(f.x-o.x,f.y-o.y,f.z-o.z),h.multiply(r)}}return s}}var y2=[-1,0,1].flatMap(n=>[-1,0,1].flatMap(e=>[-1,0,1].map(t=>[n,e,t]))),v2=new at;function By(n,e){let t=n.parts.map(x=>({...x,...x.mesh?b2(x.mesh,e):{}})),i={values:e(n.bows),shape:n.bows.shape},s=Fy(n.bodies,n.turns),r=Math.min(...n.joints.map(x=>x.lower)),o=Math.max(...n.joints.map(x=>x.upper)),a=new Float64Array(n.turns.length),l=n.fold&&e(n.fold);function c(x){if(l)return u(x);for(let[g,m]of n.turns.entries())a[g]=m.built;for(let g of n.joints)a[g.turn]=Math.min(g.upper,Math.max(g.lower,x));return a}function u(x){let[g,m]=n.fold.shape,_=o>0?x/o*(g-1):0,b=Math.min(Math.floor(_),Math.max(g-2,0)),v=Math.min(b+1,g-1);for(let E=0;E<m;E++){let A=l[b*m+E];a[E]=A+(_-b)*(l[v*m+E]-A)}return a}let h=(x,g)=>new G(...x.apart).multiplyScalar(g);function d(x,g,m,_=new at){let b=h(x,m);return _.copy(x.body===null||x.body<0?v2:g[x.body]).multiply(new at().makeTranslation(b.x,b.y,b.z))}function f(x,g,{apart:m,side:_}){let b=h(x,m);return x.root?Uy(yp(x.root,g,b),x.root.diameter):Oy(x.strap,_p(x.strap,g,_,b,i),g)}function p(x,g,{apart:m,side:_}){let b=[];for(let v of x){if(v.outer){let y=d(v,g,m);for(let M of v.outer)b.push(...M.clone().applyMatrix4(y).toArray());continue}let E=h(v,m),A=v.root?[yp(v.root,g,E)]:_p(v.strap,g,_,E,i).map(y=>y.points);for(let y of A)for(let M=0;M<y.length;M+=4)b.push(...y[M].toArray())}return Float64Array.from(b)}return{parts:t,looks:n.looks,joints:n.joints,folds:!!l,turns:n.turns,lowest:r,highest:o,turn:s,anglesTogether:c,matrixOf:d,bentMesh:f,outline:p,straps:t.filter(x=>x.strap).map(x=>x.strap),strapStretches:Dy}}function b2({points:n,triangles:e,stops:t,edges:i},s){let r=s(n),o=s(e),a=n.shape[0];for(let l=0;l<o.length;l+=3)o[l+1]=(o[l]+o[l+1])%a,o[l+2]=(o[l]+o[l+2])%a;return{places:r,corners:o,stops:t,edges:s(i),outer:S2(r)}}function S2(n){let e=new Set;for(let[t,i,s]of y2){let[r,o]=[0,-1/0];for(let a=0;a<n.length;a+=3){let l=t*n[a]+i*n[a+1]+s*n[a+2];l>o&&([r,o]=[a,l])}e.add(r)}return Array.from(e,t=>new G().fromArray(n,t))}function zy(n,e){let t=e(n.time),i=e(n.angles),[,s]=n.angles.shape,r=new Float64Array(s);function o(a){let[l,c]=Rr(t,a),u=Math.min(l+1,t.length-1);for(let h=0;h<s;h++){let d=i[l*s+h];r[h]=d+c*(i[u*s+h]-d)}return r}return{time:t,anglesAt:o,marks:n.marks,stages:n.stages,spans:n.spans}}var M2="#14171a",w2=.55,A2=Math.cos(Math.PI/9),E2=.42;function Vy(n,e,t,i){let s=n.parts.map(f=>T2(f,n.looks[f.look].colour,i)),r=new Bn;for(let f of s)r.add(f.mesh,f.lines);let o=new Bn,a=n.turn(n.anglesTogether(0));function l(f){a=n.turn(t(f));for(let[p,x]of n.parts.entries()){let{mesh:g,lines:m}=s[p],_=!e.hidden.has(x.look);for(let b of[g,m])b.visible=_;_&&(x.places?n.matrixOf(x,a,e.apart,g.matrix):P2(s[p],n.bentMesh(x,a,e)))}}function c(){let f=new $e(_t("--accent"));for(let[p,{mesh:x}]of s.entries())for(let g of[x.material].flat())g.emissive.copy(f),g.emissiveIntensity=e.chosen===p?E2:0}function u(f,p){let x=new Sr;x.setFromCamera(f,p),r.updateMatrixWorld(!0);for(let{mesh:m}of s)m.geometry.boundingSphere===null&&m.geometry.computeBoundingSphere();let[g]=x.intersectObjects(s.map(m=>m.mesh).filter(m=>m.visible),!1);return g?s.findIndex(m=>m.mesh===g.object):null}function h(f){let p=n.parts.findIndex(_=>_.name===f),{mesh:x}=s[p],g=x.geometry.getAttribute("position"),m=new an(g.array.slice(),3);return Array.from(m.applyMatrix4(x.matrix).array)}function d(){for(let{mesh:f,lines:p}of s){f.geometry.dispose(),p.geometry.dispose();for(let x of[f.material,p.material].flat())x.dispose()}}return{group:r,shadow:o,pose:l,paint:c,sort:()=>{},at:u,verticesOf:h,dispose:d,current:()=>a}}function T2(n,e,t){let i=(u,h)=>new Ss({color:u,side:zn,flatShading:h,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),s=n.places?C2(n):new yn,r=n.places?[i(t,!1),i(e,!1)]:i(e,!0),o=new On(s,r),a=new yn;n.places&&a.setAttribute("position",new an(Gy(n.places,n.edges),3));let l=new $s({color:M2,transparent:!0,opacity:w2}),c=new br(a,l);for(let u of[o,c])Object.assign(u,{frustumCulled:!1,matrixAutoUpdate:!1});return c.matrix=o.matrix,{mesh:o,lines:c}}function C2({places:n,corners:e,stops:t}){let i=new yn;return i.setAttribute("position",new an(Gy(n,e),3)),i.setAttribute("normal",new an(R2(n,e),3)),i.addGroup(0,3*t,0),i.addGroup(3*t,e.length-3*t,1),i}function Gy(n,e){let t=new Float32Array(3*e.length);for(let[i,s]of e.entries())for(let r=0;r<3;r++)t[3*i+r]=n[3*s+r];return t}function R2(n,e){let t=e.length/3,i=new Float64Array(e.length),s=Array.from({length:n.length/3},()=>[]);for(let l=0;l<t;l++){let[c,u,h]=[0,1,2].map(f=>3*e[3*l+f]),d=(f,p,x)=>n[p+x%3]-n[f+x%3];for(let f=0;f<3;f++)i[3*l+f]=d(c,u,f+1)*d(c,h,f+2)-d(c,u,f+2)*d(c,h,f+1);for(let f=0;f<3;f++)s[e[3*l+f]].push(l)}let r=Float64Array.from({length:t},(l,c)=>Math.hypot(...i.subarray(3*c,3*c+3))),o=new Float32Array(3*e.length),a=(l,c)=>i[3*l]*i[3*c]+i[3*l+1]*i[3*c+1]+i[3*l+2]*i[3*c+2];for(let l=0;l<e.length;l++){let c=Math.floor(l/3),u=[0,0,0];for(let d of s[e[l]])if(d===c||a(c,d)>=A2*r[c]*r[d])for(let f=0;f<3;f++)u[f]+=i[3*d+f];let h=Math.hypot(...u)||1;for(let d=0;d<3;d++)o[3*l+d]=u[d]/h}return o}function P2({mesh:n,lines:e},{triangles:t,edges:i}){for(let[s,r]of[[n,t],[e,i]]){let{geometry:o}=s,a=o.getAttribute("position");a?.count!==r.length&&(a=new an(new Float32Array(3*r.length),3),o.setAttribute("position",a));for(let[l,c]of r.entries())c.toArray(a.array,3*l);a.needsUpdate=!0,o.boundingSphere=null}}var I2=.25,Hy=60,L2=4;async function Wy(n){let e=await wy(n.arrays),t=By(n,e),i={apart:0,side:1,hidden:new Set,chosen:null},s=[N2(t,i),...n.motion?[D2(t,i,zy(n.motion,e))]:[]],r=O2(s),o=document.getElementById("player"),a=k2(o,n,t,i,r),l=H2(t,n,i,a);return a.onPress(l.choose),{model:t,state:i,clock:s[0].clock,run:s[1]?.clock??null,...a,choose:l.choose}}function N2(n,e){let[t,i]=n.folds?[n.lowest,n.highest]:[n.highest,n.lowest],s=h=>t+h*(i-t),r=h=>(h-t)/(i-t||1),o=Float64Array.from({length:Hy+1},(h,d)=>d/Hy),a=h=>n.anglesTogether(s(h)),l=$y(n,e,{time:o,anglesAt:a,marks:[],stages:[]}),c=Oi([Xy(n,l,a)],[{name:"",label:"",start:0,end:1,origins:[0],whole:!1}]);c.setSpeed(I2);let u=Ry(n,c,s,r);return{name:n.folds?"along the fold path":"all joints together",clip:l,clock:c,anglesAt:a,control:u}}function D2(n,e,t){let i=$y(n,e,t),s=Oi([Xy(n,i,t.anglesAt)],t.spans);return{name:"as in the simulated run",clip:i,clock:s,anglesAt:t.anglesAt,control:Ru([i],s)}}function $y(n,e,{time:t,anglesAt:i,marks:s,stages:r}){let o=()=>{let a=n.parts.filter(l=>!e.hidden.has(l.look));return a.length?a:n.parts};return{name:"",time:t,start:t[0],end:t[t.length-1],marks:s,stages:r,readings:[],along:[],reach:0,mesh:{tubes:[],joints:[],jointRadius:0},pointsAt:a=>n.outline(o(),n.turn(i(a)),e),stageAt:a=>r.findLast(l=>l.start<=a)??r[0],markAt:a=>s.find(l=>Math.abs(l.time-a)<1e-9)}}function Xy(n,e,t){let i=n.parts.filter(s=>s.outer).map(s=>({...s,outer:[s.outer[0],s.outer.at(-1)]}));return{...e,pointsAt:s=>n.outline(i,n.turn(t(s)),{apart:0,side:1})}}function O2(n){let e=n[0],t={of:null},i=new Set;for(let a of n)a.clock.onChange(()=>{if(a===e)for(let l of i)l()});let s=()=>e.clock.redraw(),r={get time(){return e.clock.time},get playing(){return e.clock.playing},get span(){return t.of!==e.clock.span&&(t={...e.clock.span,of:e.clock.span}),t},clipTime:(a,l)=>e.clock.clipTime(a,l),timeAt:a=>e.clock.timeAt(a),wayAt:a=>e.clock.wayAt(a),onChange(a){return i.add(a),s(),()=>i.delete(a)},seek:a=>e.clock.seek(a),seekClip:(a,l)=>e.clock.seekClip(a,l),step:a=>e.clock.step(a),play:()=>e.clock.play(),pause:()=>e.clock.pause()};return{clip:{...n[0].clip,pointsAt:a=>e.clip.pointsAt(a)},clock:r,sources:n,get now(){return e},anglesAt:a=>e.anglesAt(a),take(a){e.clock.pause(),e=n[a],t={of:null},s()},changed(){t={of:null},s()}}}var qy="Press a part, or its name in the table, for details.",U2="parts";function k2(n,e,t,i,s){let{clip:r,clock:o,sources:a}=s,l=null,u=Qa([r],o,()=>l=Vy(t,i,s.anglesAt,e.stopColour),e.text),h=Iu(u.eye,null);h.prepend(Tu(u,o,()=>({text:"",longest:0}),()=>[]));let d=S("div",{className:"picture"},u.element,...u.note?[u.note]:[],h),f=S("p",{className:"chosen",role:"status"},qy),p=S("div",{},a[0].control);return n.replaceChildren(d,f,p,F2(t,i,s,p),B2(t,i,s),z2(e,t,u),vu([r],U2)),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label","the moving parts"),bu(n,[r],o,u.eye,Pr[0]),{stage:u,shape:l,info:f,repaint:()=>{l.paint(),o.seek(o.time)},onPress:x=>G2(u.canvas,g=>x(l.at(g,u.eye.camera)))}}function F2(n,e,t,i){let s=l=>{Object.assign(e,l),t.changed()},r=t.sources.map(l=>l.name),o=xp("motion",r,l=>{t.take(l),i.replaceChildren(t.now.control)}),a=xp("slack straps bow",["away from the hinge","towards the hinge"],l=>s({side:l?-1:1}));return S("div",{className:"choices"},...r.length>1?[o]:[],Iy(l=>s({apart:l})),...n.straps.length?[a]:[])}function B2(n,e,t){let i=n.looks.map((s,r)=>n.parts.reduce((o,a)=>o+(a.look===r?a.count:0),0));return Ly(n.looks,i,(s,r)=>{r?e.hidden.delete(s):e.hidden.add(s),t.changed()})}function z2(n,e,t){let i=S("span",{className:"swatch taut","aria-hidden":"true"});return S("ul",{className:"legend"},...e.parts.some(s=>s.stops)?[V2(n.stopColour,"face of a stop")]:[],...e.straps.length?[S("li",{},i,"on the slider: range of taut straps")]:[],S("li",{},`squares of the grid: ${bt(1e3*Ka(t.eye.size))} mm`))}function V2(n,e){let t=S("span",{className:"swatch panel","aria-hidden":"true"});return t.style.background=n,S("li",{},t,e)}function G2(n,e){let t=null;n.addEventListener("pointerdown",i=>{t=i.isPrimary?[i.clientX,i.clientY]:null}),n.addEventListener("pointerup",i=>{if(t===null||Math.hypot(i.clientX-t[0],i.clientY-t[1])>L2)return;let s=n.getBoundingClientRect(),[r,o]=[(i.clientX-s.left)/s.width,(i.clientY-s.top)/s.height];e(new Ye(2*r-1,1-2*o))})}function H2(n,e,t,i){let r=Array.from(document.querySelectorAll("#bill tbody tr")).map((l,c)=>{let[u]=l.querySelector("th").childNodes,h=S("button",{type:"button",className:"name","aria-pressed":"false"},u.textContent);return u.replaceWith(h),h.addEventListener("click",()=>o(t.chosen===c?null:c)),h});function o(l){t.chosen=l;for(let[c,u]of r.entries())u.setAttribute("aria-pressed",String(c===l));i.info.textContent=l===null?qy:a(l),i.repaint()}function a(l){let c=n.parts[l],[u,h,d]=c.facts,f=c.count>1?`${c.count} identical ones, each `:"";return`${c.name}: ${n.looks[c.look].name} of ${u}, ${f}${h}, ${d}`}return{choose:o}}var W2=[.1,.2,.5,1,2,5,10,15,30,45,60,90,180],$2=1.35;function vp(n,e,t=[],i=null){let s=e.map(r=>X2(r,t[0],i));n.replaceChildren(...s.map(r=>r.element)),n.classList.add("plots");for(let r of s)r.start();return s}function X2(n,e,t){let[i,s,r]=[n.lines,n.balls,n.marks].map(y=>y.map(q2)),{element:o,head:a,key:l,place:c}=sp(n),u=(s.length?s:[i[0]]).map(y=>S("span",{className:"ball"},s.length&&y.name.length<3?y.name:"")),h=s.map(y=>[y.places[0],y.values[0]]),d=Math.round($2*rh),f=Y2(i),p=f,x=null,g=[];function m(){let y=i.map((I,L)=>S("li",{},pr(Di(L)),I.name)),M=s.length?`the ${n.along} now`:"moved by the slider";l.replaceChildren(...y,S("li",{},S("span",{className:"ball still"}),M))}function _(){for(let[y,[M,I]]of h.entries()){let[L,C]=[x.valToPos(M,"x"),x.valToPos(I,"y")];u[y].style.transform=`translate(${L.toFixed(2)}px, ${C.toFixed(2)}px)`}}function b(){let y=t.clipTime(0);for(let[M,{places:I,values:L}]of s.entries())h[M]=[I,L].map(C=>tr(e.time,C,y));_()}function v(y){p=y,x.setScale("x",{min:y[0],max:y[1]})}function E(y,M,I){if(p!==f){let{places:D,values:k}=i[0],N=k.filter((H,se)=>D[se]>=p[0]&&D[se]<=p[1]),[B,$]=[Math.min(...N),Math.max(...N)];return[B-.25*($-B),$+.25*($-B)]}let L=s.reduce((D,k)=>Math.max(D,k.most),I),C=Math.min(0,M);return[C-.06*(L-C||1),L+.1*(L-C||1)]}function A(){let y=ln.join(i.map(L=>[L.sorted.places,L.sorted.values]));x=new ln(Z2({data:n,lines:i,balls:s,marks:r,energyRange:E},c.clientWidth,d),y,c),x.over.append(...u);let M=new ResizeObserver(()=>x.setSize({width:c.clientWidth,height:d}));M.observe(c),x.hooks.setSize=[_],x.hooks.setScale=[_],m();let I=Qs(()=>{m(),x.redraw(!1)});a.append(rp(n,()=>x,{under:()=>[],over:()=>[...Yy(x,n.along==="run"?s:[]),...Zy(x,r)]})),g=[I,()=>M.disconnect(),()=>x.destroy()],n.top&&c.after(K2(f,n.top,v)),s.length?(t.onChange(b),J2(x,s,e,t)):j2(n,i[0],c,(L,C)=>{h[0]=[L,C],_()}),v(f)}return{element:o,start:A,dispose:()=>g.forEach(y=>y()),now:h,get chart(){return x}}}function q2({name:n,places:e,values:t}){let i={name:n,places:qt(e,Float32Array),values:qt(t,Float32Array)},s=Array.from(i.places.keys()).sort((r,o)=>i.places[r]-i.places[o]);return i.most=i.values.reduce((r,o)=>Math.max(r,o),0),i.sorted={places:s.map(r=>i.places[r]),values:s.map(r=>i.values[r])},i}function Y2(n){let e=n.flatMap(s=>[s.sorted.places[0],s.sorted.places.at(-1)]),[t,i]=[Math.min(...e),Math.max(...e)];return[t-.03*(i-t),i+.03*(i-t)]}function Z2({data:n,lines:e,balls:t,marks:i,energyRange:s},r,o){let a=oh(),l=lp(n);return{width:r,height:o,legend:{show:!1},cursor:{show:!1},pxAlign:0,padding:[10,12,0,0],scales:{x:{time:!1,auto:!1,dir:n.backwards?-1:1},y:{range:s}},series:[{},...op(e)],axes:[{...a,...ap,labelFont:a.font,label:`${n.axis} (deg)`,values:l.values,incrs:W2,space:44},l],hooks:{draw:[c=>sh(c,[...Yy(c,n.along==="run"?t:[]),...Zy(c,i)])]}}}function Yy(n,e){let[t,i]=[n.bbox.width/devicePixelRatio,n.bbox.height/devicePixelRatio];return e.flatMap(({places:r,values:o})=>Array.from(r,(a,l)=>[n.valToPos(a,"x"),n.valToPos(o[l],"y")])).filter(([r,o])=>r>0&&r<t&&o>0&&o<i).map(([r,o])=>({kind:"rect",x:r-.8,y:o-.8,width:1.6,height:1.6,fill:_t("--accent"),opacity:.55}))}function Zy(n,e){let[t,i]=[n.bbox.width/devicePixelRatio,n.bbox.height/devicePixelRatio],s=e.flatMap(({name:r,places:o,values:a})=>{let l=Array.from(o,(f,p)=>[n.valToPos(f,"x"),n.valToPos(a[p],"y")]),[c,u]=l[l.length>>1],h=l.length===1?{kind:"circle",x:c,y:u,r:4.5,fill:_t("--page"),stroke:_t("--ink"),lineWidth:1.4}:{kind:"path",points:l,stroke:_t("--line-2"),lineWidth:7,opacity:.35},d=l.length>1?0:c>t/2?-1:1;return[h,{kind:"text",x:c+12*d,y:u-9,text:r,anchor:["end","middle","start"][d+1],fill:_t("--ink")}]});return[{kind:"clip",x:-6,y:0,width:t+12,height:i+6,shapes:s}]}function K2(n,e,t){let i=[["whole curve",n],["barrier enlarged",e]].map(([s,r],o)=>{let a=S("button",{type:"button","aria-pressed":String(o===0)},s);return a.addEventListener("click",()=>{for(let l of i)l.setAttribute("aria-pressed",String(l===a));t(r)}),a});return S("div",{className:"ranges",role:"group","aria-label":"part of the curve"},...i)}function J2(n,e,t,i){cp(n,r=>{let o=n.over.getBoundingClientRect(),[a,l]=[r.clientX-o.left,r.clientY-o.top],[c,u]=[0,1/0];for(let{places:h,values:d}of e)for(let f=0;f<h.length;f++){let p=Math.hypot(n.valToPos(h[f],"x")-a,n.valToPos(d[f],"y")-l);p<u&&([c,u]=[f,p])}i.pause(),i.seekClip(0,t.time[c])})}function j2(n,e,t,i){let s=e.places.length-1,r=S("input",{type:"range",min:"0",max:String(s),value:"0"});r.setAttribute("aria-label",`${n.axis} along the curve`);let o=S("output",{"aria-live":"off"}),a=()=>{let l=Number(r.value);i(e.places[l],e.values[l]);let[c,u]=[bt(e.places[l]),`${bt(e.values[l])} ${n.unit}`];o.textContent=`${c}°, ${u}`,r.setAttribute("aria-valuetext",`${n.axis} ${c} degrees, energy ${u}`)};r.addEventListener("input",a),t.after(S("div",{className:"slide"},r,o)),a()}function _h(n,e,t){let i=e.map(({name:l,title:c})=>{let u=S("button",{type:"button",title:`${l}: ${c}`},l);return u.addEventListener("click",()=>t(l)),u}),s=l=>{for(let c of i)c.setAttribute("aria-pressed",String(c.textContent===l))},r=e.map(({name:l,title:c})=>`${l}: ${c}`).join(" · "),o=`how the ${n} moves`;return{element:S("div",{className:"colours modes",role:"group","aria-label":o},S("span",{},...i),S("small",{},r)),mark:s}}function bp(n){let e=(n.paths??[]).map(c=>({...c,clips:c.clips.map(u=>({...n.clips?.[0],...u}))})),i=[...n.clips?[{...n,name:"motion",title:"in time, as simulated"}]:[],...e].map(Q2),s={views:i};if(!i.length)return{...s,curves:vp(document.getElementById("curves"),n.curves)};let r=document.getElementById("player"),o=null,a;s.choose=c=>{o?.leave(),o=c,a=c.show(a)??a,Object.assign(s,c),l.mark(c.name)};let l=_h(n.whole,i,c=>s.choose(i.find(u=>u.name===c)));if(i.length>1&&r.before(l.element),s.choose(i[0]),n.clips){ah(r,s.clock);let c=i.find(h=>h!==i[0]),u=c&&(()=>{s.choose(c),r.scrollIntoView({block:"start"}),r.querySelector("input[type=range]").focus({preventScroll:!0})});s.trial=Uu(document.getElementById("try"),i[0].clips[0],n,()=>s.clock.pause(),u)}return s}function Q2(n){let{name:e,title:t}=n,i=n.clips.map(Jn),s={name:e,title:t,clips:i,clock:null},r=[];return s.show=o=>{let a=u=>document.getElementById(u),l=Oi(i,n.spans);return s.clock&&l.seek(s.clock.time),s.clock=l,s.player=rr(a("player"),i,l,n,o,!1),s.curves=n.curves?vp(a("curves"),n.curves,i,l):[],s.plots=cr(a("plots"),n.plots,i,l),n.notes&&a("player").append(...n.notes.map(u=>S("p",{className:"note"},u))),r=[or(a("readout"),i[0],l,n.energy),()=>s.player.dispose(),()=>s.plots.dispose(),()=>s.curves.forEach(u=>u.dispose())],s.player.stage?.eye.look},s.leave=()=>r.forEach(o=>o()),s}var Jy={"Content-Type":"application/json"},Ky=19e6;async function Ps(n,e,t){let i=JSON.stringify(e);if(i.length>Ky)return{refused:`need files of at most ${Ky/1e6} MB in all`};try{return await(await fetch(n,{method:"POST",headers:Jy,body:i,signal:t})).json()}catch(s){if(s.name==="AbortError")throw s;return{refused:Sp}}}async function yh(n,e,t,i){let s="",r={};try{let a=(await fetch(n,{method:"POST",headers:Jy,body:JSON.stringify(e),signal:t})).body.pipeThrough(new TextDecoderStream).getReader();for(let l=await a.read();!l.done;l=await a.read()){let c=`${s}${l.value}`.split(`
`);s=c.pop();for(let u of c)r=JSON.parse(u),i(r)}s&&(r=JSON.parse(s))}catch(o){if(o.name==="AbortError")throw o;return{refused:Sp}}return r.done||r.refused?r:{refused:Sp}}var Sp="the workbench does not answer; is forficula open still running?";var Mp=`forficula ${location.pathname}`;function Qy(n){let e={asked:null,base:null,reply:null,rejected:new Map};e.open=async(r,o)=>{let a=r.files[0]?.name||r.design||"the design",l={...r,settings:o};n.says.wait(`Opening ${a}`);let c=n.picture(l,!0),u=await Ps("design",{...r,settings:{}}),h=u.refused??await t(l,u,c);return h?(n.says.refuse(`${a} is not opened: ${h}`),n.resume()):e.rejected.clear(),e.reply&&s(e.reply),h};async function t(r,o,a=null){let l=performance.now(),c=new AbortController,u=()=>{Object.assign(e,{asked:r,base:o}),s(h)};n.says.wait("Building",()=>c.abort());let h=o;try{if(Object.keys(r.settings).length&&(h=await Ps("design",r,c.signal)),h.refused)return h.refused;let d=await eI(a??n.picture(r,!1),c.signal);if(d.refused)return d.refused;d.shown&&(u(),n.says.wait("Building"));let f=await Ps("model",r,d.shown?void 0:c.signal);if(f.refused&&!d.shown)return f.refused;d.shown||u(),await n.model(f.refused?{live:f,warnings:[]}:f),n.says.done(`Built in ${((performance.now()-l)/1e3).toFixed(1)} s.`)}catch(d){if(d.name!=="AbortError")throw d;return"building was stopped"}return""}e.change=async(r,o)=>{let{asked:a,rejected:l}=e,c=[...l].filter(([f])=>f!==r).map(([f,p])=>[f,p.text]),u=i(a.settings,[[r,o]]),h=c.length?[i(a.settings,[...c,[r,o]]),u]:[u],d="";for(let f of h)if(d=jy(f,a.settings)?"":await t({...a,settings:f},e.base),!d){f===h[0]?l.clear():l.delete(r);break}d?(l.set(r,{text:o,why:d}),n.says.refuse(`${d} – the last working model is kept`),n.resume()):jy(u,a.settings)&&n.says.done(""),s(e.reply)},e.slide=async r=>{let o=i(e.asked.settings,Object.entries(r)),a=await Ps("design",{...e.asked,settings:o});return a.refused?n.says.refuse(a.refused):(e.asked={...e.asked,settings:o},s(a))};function i(r,o){let a={...r};for(let[l,c]of o)c===""||c===e.base.keys.find(u=>u.key===l)?.value?delete a[l]:a[l]=c;return a}function s(r){e.reply=r,tI(e.asked),n.reply(e)}return e}function eI(n,e){let t=new Promise((i,s)=>e.addEventListener("abort",()=>s(e.reason)));return Promise.race([n,t])}var jy=(n,e)=>JSON.stringify(Object.entries(n).sort())===JSON.stringify(Object.entries(e).sort());function ev(){return JSON.parse(sessionStorage.getItem(Mp)??"null")}function tI(n){try{sessionStorage.setItem(Mp,JSON.stringify(n))}catch{sessionStorage.removeItem(Mp)}}function tv(n){let e=S("textarea",{id:"file-text",className:"file",rows:24,spellcheck:!1,"aria-describedby":"file-note"}),t=S("button",{type:"button"},"Build this text"),s=S("div",{},S("label",{htmlFor:"file-text"},"The design file"),S("p",{className:"note",id:"file-note"},"Add or remove stages, tendons and whole sections here. The result counts as a new design file."),e,S("p",{className:"choices"},t));t.addEventListener("click",()=>n(e.value));let r="";return{element:s,show(o){o.text!==r&&(e.value=r=o.text)}}}function vh(n,e){let t="";for(let i of new TextEncoder().encode(n))t+=String.fromCharCode(i);return`data:${e};base64,${btoa(t)}`}var wp=40,nI=0;function nv(n,e){let t=`key-${++nI}`,i=n.key.split(".").at(-1).replaceAll("_"," "),s=iI(n,t),r=S("button",{type:"button",className:"home",hidden:!0},"undo"),o=S("p",{className:"wrong",id:`${t}-wrong`}),a="",l=S("p",{className:"note",id:`${t}-notes`}),c=S("div",{className:"field"},S("label",{htmlFor:t,title:n.key},i),S("span",{className:"entry"},s,...sI(n,t),r),o,l);s.setAttribute("aria-describedby",`${t}-wrong ${t}-notes`),s.addEventListener("change",()=>{a=s.value.trim(),e(a)}),r.addEventListener("click",()=>{e(""),s.focus()}),r.setAttribute("aria-label",`undo the change of ${i}`);function u(d,f,p){(document.activeElement!==s||s.value.trim()===a)&&(s.value=f??d.value),a=s.value.trim(),h("");let x=f===void 0?null:p?.value||"left out";c.classList.toggle("changed",x!==null),r.hidden=x===null;let g=d.default&&d.default!=="needed"?`if left out ${d.default}`:"",_=[d.allowed,x===null?g:`was ${x}`,d.chosen&&`chosen: ${d.chosen}`].filter(Boolean).join(" · ").replaceAll(">=","≥").replaceAll("<=","≤");l.replaceChildren(Ot(d.meaning),S("span",{className:"may"},_))}function h(d,f){f!==void 0&&(s.value=a=f),o.textContent=d,c.classList.toggle("rejected",d!==""),d?(s.setAttribute("aria-invalid","true"),r.hidden=!1):s.removeAttribute("aria-invalid")}return{element:c,input:s,fact:n,show:u,reject:h}}function iI({key:n,value:e,words:t,onlyWords:i,default:s},r){if(i){let l=e?[]:[S("option",{value:""},s&&s!=="needed"?`left out: ${s}`:"left out")];return S("select",{id:r,"data-key":n},...l,...t.map(c=>S("option",{value:c},c)))}let o={id:r,spellcheck:!1,autocomplete:"off",autocapitalize:"off","data-key":n};if(e.length>wp)return S("textarea",{...o,rows:Math.min(6,Math.ceil(e.length/wp))});let a=S("input",{...o,type:"text"});return t.length&&a.setAttribute("list",`${r}-words`),a}function sI({words:n,onlyWords:e,value:t},i){return e||!n.length||t.length>wp?[]:[S("datalist",{id:`${i}-words`},...n.map(s=>S("option",{value:s})))]}var rI=["pattern","tendon"];function iv(n){let e=S("input",{type:"search",id:"find-key",spellcheck:!1,placeholder:"stiffness, length, torque …"}),t=S("p",{className:"note",role:"status"}),i=S("div",{className:"sections"}),s=S("section",{className:"keys-of-design","aria-label":"keys of the design"},S("h2",{},"Keys"),S("label",{className:"find",htmlFor:"find-key"},"Find a key",e),t,i),r=new Map,o=[];e.addEventListener("input",a);function a(){let h=e.value.toLowerCase().split(/\s+/).filter(Boolean),d=0;for(let{fact:f,element:p}of r.values()){let x=`${f.key.replaceAll("_"," ")} ${f.key} ${f.meaning}`.toLowerCase();p.hidden=!h.every(g=>x.includes(g)),d+=p.hidden?0:1}for(let f of o){f.element.hidden=f.fields.every(p=>p.element.hidden);for(let{heading:p,fields:x}of f.parts)p.hidden=x.every(g=>g.element.hidden);h.length&&!f.element.hidden&&(f.element.open=!0)}t.textContent=h.length?`${d} of ${r.size} keys`:`${r.size} keys; enter values with units, as in a design file`}function l(h,d,f){let p=new Map(f.keys.map(x=>[x.key,x]));oI(h.keys,r)||c(h);for(let x of h.keys)r.get(x.key).show(x,d[x.key],p.get(x.key));for(let x of o)x.count(d);a()}function c(h){let d=new Set(o.length?o.filter(({element:x})=>x.open).map(({name:x})=>x):rI),f=document.activeElement?.dataset?.key;r=new Map(h.keys.map(x=>[x.key,nv(x,g=>n(x.key,g))])),o=[...new Set(h.keys.map(({key:x})=>x.includes(".")?x.split(".")[0]:""))].sort((x,g)=>(g===""?-1:0)-(x===""?-1:0)).map(x=>aI(x,h,r));for(let x of o)x.element.open=d.has(x.name);i.replaceChildren(...o.map(x=>x.element)),f&&r.get(f)?.input.focus()}function u(h,d,f){let p=r.get(h);if(p){p.reject(f,d);for(let x of o)x.fields.includes(p)&&(x.element.open=!0)}}return{element:s,show:l,reject:u,field:h=>r.get(h)}}function oI(n,e){let t=[...e.keys()],i=(s,r)=>s.key===r&&s.onlyWords===e.get(r).fact.onlyWords;return n.length===t.length&&n.every((s,r)=>i(s,t[r]))}function aI(n,e,t){let i=e.keys.filter(({key:d})=>(d.includes(".")?d.split(".")[0]:"")===n),s=i.map(({key:d})=>t.get(d)),r=S("summary"),o=e.sections[n],a=[],l=[];for(let{key:d}of i){let f=d.split(".").slice(1,-1).join(".");if(f!==(a.at(-1)?.within??"")){let p=e.keys.find(g=>g.key===`${n}.${f}.name`)?.value,x=S("h3",{},`${n}.${f}${p?` · ${p}`:""}`);a.push({within:f,heading:x,fields:[]}),l.push(x)}a.at(-1)?.fields.push(t.get(d)),l.push(t.get(d).element)}let c=o?[S("p",{className:"note"},`${Ot(o).replace(/\.$/,"")}.`)]:[],u=S("details",{},r,...c,...l);function h(d){let f=i.filter(({key:p})=>p in d).length;r.replaceChildren(n?Ot(n):"Name",...f?[S("small",{},` ${f} changed`)]:[])}return{name:n,element:u,fields:s,parts:a.filter(({heading:d})=>d),count:h}}function sv(n,e,t){let i=S("option",{value:""},e),s=n.filter(({name:f})=>f!==e).map(({name:f,shows:p})=>S("option",{value:f,title:p},f)),r=S("select",{id:"which-design"},i,...s),o=S("input",{type:"file",id:"which-files",multiple:!0,accept:".toml,.fold,.svg,.dxf",className:"spoken"}),a=S("input",{type:"text",id:"which-unit",placeholder:"1 cm",size:6,spellcheck:!1}),l="A design (.toml, with the files that it names), a FOLD file or a drawing (.svg, .dxf) can be dropped anywhere on the page.",c=S("label",{className:"button",htmlFor:"which-files"},"Open files …"),u=S("div",{className:"opening choices"},S("label",{htmlFor:"which-design"},"design ",r),S("span",{className:"choosing"},o,c),S("label",{htmlFor:"which-unit",title:"for a FOLD file or a drawing without a unit"},"unit of a drawing ",a),S("p",{className:"note"},l));r.addEventListener("change",()=>t({design:r.value,files:[],unit:""})),o.addEventListener("change",async()=>{o.files.length&&await d([...o.files]),o.value=""}),a.addEventListener("change",()=>{h&&t({design:"",files:h,unit:a.value.trim()})});let h=null;async function d(f){let p=await Promise.all(f.map(async x=>({name:x.name,text:await x.text()})));h=lI(p),await t({design:"",files:h,unit:a.value.trim()})}return cI(d),{element:u,show({design:f,files:p}){r.querySelector(".sent")?.remove(),p.length&&r.append(S("option",{value:p[0].name,className:"sent"},p[0].name)),r.value=p.length?p[0].name:f,h=p.length?p:null}}}function lI(n){let e=n.filter(({name:i})=>/\.toml$/i.test(i)),t=e.find(({name:i})=>!e.some(s=>s.name!==i&&s.text.includes(i)))??n[0];return[t,...n.filter(i=>i!==t)]}function cI(n){let{body:e}=document,t=i=>{i.dataTransfer?.types.includes("Files")&&(i.preventDefault(),e.classList.add("dropping"))};e.addEventListener("dragenter",t),e.addEventListener("dragover",t),e.addEventListener("dragleave",i=>{i.relatedTarget||e.classList.remove("dropping")}),e.addEventListener("drop",i=>{e.classList.remove("dropping"),i.dataTransfer?.files.length&&(i.preventDefault(),n([...i.dataTransfer.files]))})}function rv(n,{button:e,text:t,title:i},s){let r=S("button",{type:"button",className:"try"},e),o=S("button",{type:"button",hidden:!0},"Stop"),a=S("p",{className:"note",role:"status"},t),l=S("div"),c=S("div",{className:"results"},S("div",{className:"offer"},r,o,a),l),u=null,h=null;async function d(){if(h)return;let x=s(),g=performance.now();h=new AbortController,r.disabled=!0,o.hidden=!1,a.textContent="Starting …";let m=!1;try{let _=await yh(n,x,h.signal,b=>{b.doing&&(a.textContent=`${b.doing} …`)});_.refused?a.textContent=`No result: ${_.refused}.`:f(_.done,x,(performance.now()-g)/1e3),m=!_.refused}catch{a.textContent="Stopped."}h=null,r.disabled=!1,o.hidden=!0,m&&p()}function f(x,g,m){u=JSON.stringify(g),a.textContent=`Done in ${m.toFixed(m<10?1:0)} s.`;let _=S("a",{href:x,target:"_blank",rel:"noopener"},"Open in a new window"),b=S("iframe",{src:x,title:i,sandbox:"allow-scripts allow-downloads"});l.replaceChildren(S("p",{},_),b)}function p(){u!==null&&!h&&u!==JSON.stringify(s())&&(a.textContent="This result belongs to the design before its last change.")}return r.addEventListener("click",d),o.addEventListener("click",()=>h?.abort()),{element:c,find:d,seen:p}}var uI=1500;function ov(){let n=S("p",{role:"status"}),e=S("p",{className:"wrong",role:"alert"}),t=S("button",{type:"button",hidden:!0},"Stop building"),i=0,s=null;t.addEventListener("click",()=>s?.());function r(o,a=""){clearTimeout(i),t.hidden=!0,n.textContent=o,e.textContent=a}return{element:S("div",{className:"says"},n,t,e),wait(o,a){r(`${o} …`),s=a,a&&(i=setTimeout(()=>t.hidden=!1,uI))},done:o=>r(o),refuse:o=>r("",o.endsWith(".")?o:`${o}.`)}}function av(){let n=S("a",{className:"button"},"Download the design"),e=S("code"),t=S("pre",{tabIndex:0,role:"group","aria-label":"the command that runs it"},e);return{element:S("div",{className:"taking"},n,t),show(i){n.href=vh(i.text,"application/toml"),n.download=`${i.name}.toml`,e.textContent=i.command}}}function lv(n){let e=S("div"),t=null;async function i(){let s=n();if(!s)return;let r=JSON.stringify(s);if(r===t)return;t=r,e.querySelector("img")||e.replaceChildren(S("p",{className:"note",role:"status"},"Drawing …"));let o=await Ps("pattern",s);if(t!==r)return;if(o.refused){e.replaceChildren(S("p",{className:"note",role:"status"},`No pattern is drawn: ${o.refused}.`));return}let a=S("img",{src:`data:image/svg+xml;base64,${o.drawing}`,alt:o.said}),l=(u,h,d)=>S("a",{className:"button",download:h,href:d},u),c=vh(o.fold,"application/json");e.replaceChildren(S("figure",{className:"drawn"},a),S("p",{className:"choices"},l("Drawing as SVG","pattern.svg",a.src),l("Pattern as FOLD","pattern.fold",c)))}return{element:e,seen:i}}function cv(n){let e={},t=0;function i(){if(clearTimeout(t),!Object.keys(e).length)return;let s=e;return e={},n(s)}return{put(s,r){e[s]=r,clearTimeout(t),t=setTimeout(i,250)},hand:i}}function uv(n,e){let t=n.map(({name:o,title:a,element:l},c)=>{l.id=`view-${o}`,l.setAttribute("role","tabpanel"),l.setAttribute("aria-labelledby",`tab-${o}`);let u=S("button",{type:"button",id:`tab-${o}`,role:"tab","aria-controls":l.id},a);return u.addEventListener("click",()=>r(c)),u}),i=S("div",{className:"tabs",role:"tablist","aria-label":e},...t),s=0;function r(o){s=o;for(let[a,l]of t.entries())l.setAttribute("aria-selected",String(a===o)),l.tabIndex=a===o?0:-1,n[a].element.hidden=a!==o;n[o].seen?.()}return i.addEventListener("keydown",({key:o})=>{let a={ArrowRight:s+1,ArrowLeft:s-1,Home:0,End:t.length-1};o in a&&(r((a[o]+t.length)%t.length),t[s].focus())}),{element:S("div",{className:"views-of-bench"},i,...n.map(({element:o})=>o)),choose:o=>r(n.findIndex(a=>a.name===o)),name:(o,a)=>t[n.findIndex(l=>l.name===o)].textContent=a,seen:()=>n[s].seen?.()}}var hv=.02;function dv(n,{moving:e,shape:t,names:i,asked:s,held:r}){let o=S("p",{className:"note",role:"status"}),a=S("button",{type:"button","aria-pressed":"false",title:"drag panels as well; otherwise dragging a panel turns the picture"},"drag panels");a.addEventListener("click",()=>a.setAttribute("aria-pressed",String(a.getAttribute("aria-pressed")!=="true")));let l=null,c=!1,u=!0,h=!0;async function d(){if(c||!l)return;let{place:A,target:y}=l,M={...s(),weights:Object.fromEntries(A),target:y,begins:u};l=null,u=!1,c=!0;let I=await Ps("drag",M);c=!1,h||f(I),d()}function f(A){let y=A.refused?`Not dragged: ${A.refused}.`:A.text;A.points&&(e.hold(qt(A.points,Float32Array)),r(!0)),m.say(y),o.textContent=y}function p(A,y){h&&(u=!0),h=!1,l={place:A,target:y.toArray()},d()}function x(){h=!0,l=null,e.hold(null),r(!1)}function g(A,y){if(a.getAttribute("aria-pressed")!=="true")return null;let M=new Sr;M.setFromCamera(new Ye(A,y),n.eye.camera);let{mesh:I}=e,L=null,C=[new G,new G,new G],D=new G,{vertices:k}=n.views[0].shape;for(let B=0;B<I.triangles.length;B+=3){let $=I.triangles.slice(B,B+3);for(let[se,Y]of $.entries())C[se].fromArray(k,3*Y);if(!M.ray.intersectTriangle(...C,!1,D))continue;let H=D.distanceTo(M.ray.origin);(!L||H<L.away)&&(L={away:H,numbers:$,shares:Zi.getBarycoord(D,...C,new G).toArray()})}if(!L)return null;let N=new Map;for(let[B,$]of L.numbers.entries())for(let[H,se]of[[I.between[2*$],1-I.share[$]],[I.between[2*$+1],I.share[$]]])se&&N.set(H,(N.get(H)??0)+se*L.shares[B]);return[...N]}let m=Du(n,{points:t,movable:i.map(A=>A!==null),between:g,moved:(A,y,M)=>p(A,M),left:x}),_=hI(n,t,i,p,x),b=S("p",{className:"note"},"Drag a vertex: the package computes the equilibrium with the springs of the creases, and the force that holds it."),v=S("div",{className:"drag"},b,o,_.element);return n.element.parentElement.querySelector(".views").prepend(S("span",{className:"panels"},a)),{element:v,end:_.end}}function hI(n,e,t,i,s){let r=Lu(t.map((f,p)=>[f,p]).filter(([f])=>f!==null)),o=Nu("drag",{clicked:u,pressed:u}),a=S("button",{type:"button"},"Release"),l=S("p",{className:"note"},"On these buttons, every arrow key drags the vertex by 2 % of the structure's size. It stays there until it is released."),c=null;function u(f){let[p,x]=tl[f],g=Number(r.value);c??=new G().fromArray(e(),3*g);let{camera:m,size:_}=n.eye;c.addScaledVector(new G().setFromMatrixColumn(m.matrixWorld,0),hv*_*p),c.addScaledVector(new G().setFromMatrixColumn(m.matrixWorld,1),hv*_*x),i([[g,1]],c)}function h(){c=null,s()}return r.addEventListener("change",h),a.addEventListener("click",h),{element:S("details",{className:"push-keys"},S("summary",{},"Drag without a pointer"),S("div",{className:"choices"},S("label",{},"point ",r),o,a),l),end:h}}function fv(n){let e=new Set,t={start:n.start,end:n.end,origins:[0]},i=n.start,s=0;function r(){s||=requestAnimationFrame(()=>{s=0;for(let o of e)o()})}return{get time(){return i},span:t,clipTime:(o,a=i)=>Math.min(n.end,Math.max(n.start,a)),timeAt:o=>t.start+o*(t.end-t.start),wayAt:o=>(o-t.start)/(t.end-t.start||1),onChange(o){return e.add(o),r(),()=>e.delete(o)},seek(o){i=Math.min(t.end,Math.max(t.start,o)),r()}}}var Ap=100;function pv(){let n=S("p",{className:"note",role:"status"}),[e,t,i,s]=["","notes","",""].map(p=>S("div",{className:p})),r=S("div",{className:"folding"},n,e,t,i,s),o={element:r,whole:"structure",share:0,complete:!1,clock:null,path:null},a=null,l=null,c=null;Object.defineProperty(o,"look",{get:()=>c?.look}),o.show=(p,{fresh:x=!1,look:g}={})=>{o.leave(),x&&(o.share=0);let m=l=Object.assign(new AbortController,{wanted:p}),_=performance.now(),b=null;return new Promise(v=>{let E=A=>{A.picture&&(b=A.picture,o.whole=b.whole,(x||!c?.grow)&&h(b,g),a=p,o.complete=!1,n.textContent="Computing the fold path …",v({shown:!0})),A.path&&d(b,A.path,m),A.done&&(n.textContent=fI(o.path,(performance.now()-_)/1e3))};yh("fold",{...p,share:x?null:o.share},m.signal,E).then(({refused:A})=>{v({refused:A}),!(!A||l!==m)&&(b&&c?.grow&&h(b,g),b&&(n.textContent=`No fold path is shown: ${A}.`))},()=>v({refused:"building was stopped"}))})},o.shows=p=>c!==null&&JSON.stringify(a)===JSON.stringify(p),o.leave=()=>{l?.abort(),l=null},o.resume=()=>{!l||l.wanted===a||(o.leave(),a&&!o.complete&&o.show(a))},o.clear=()=>{o.leave(),u(),a=null};function u(){if(!c)return;let{look:p}=c;c.dispose(),c=null,o.clock=o.path=null;for(let x of[e,t,i,s])x.replaceChildren();return p}function h(p,x){let g=u()??x??nr(),m=Jn(p.clips[0]),{stage:_}=Pu(e,[m],fv(m),{...p,text:`${p.shape}, as built.`},{...g,following:!1});e.setAttribute("aria-label",`the ${p.whole} as built`),c={clip:()=>m,look:_?.eye.look??g,dispose:()=>_?.dispose()}}function d(p,x,g){let m=Jn({...p.clips[0],...x.clips[0]});o.path=x,c?.mine===g&&c.largest===x.energy.largest_J?c.grow(m,x):f(m,x,g,p.points),x.complete&&c.complete(x),o.complete=x.complete}function f(p,x,g,m){let _=e.contains(document.activeElement),b=c?.clip(),v=u()??nr(),E=dI(p);b?.mesh.pointCount===p.mesh.pointCount&&E.lend(b);let A=Oi([E],x.spans);A.seek(Ap*o.share);let y=rr(e,[E],A,x,v,!1);y.stage?.eye.aim(),E.lend(null);let M=null,I=()=>{o.share!==A.time/Ap&&M?.end(),o.share=A.time/Ap},L=[()=>y.dispose(),A.onChange(I)];c={mine:g,clip:E.now,look:y.stage?.eye.look??v,largest:x.energy.largest_J,dispose:()=>L.forEach(C=>C()),grow(C){E.replace(C),A.redraw()},complete({plots:C,notes:D,energy:k,spans:N}){A.setSpan({...N[0]}),t.replaceChildren(...D.map(H=>S("p",{className:"note"},H)));let B=H=>{r.classList.toggle("pulled",H),A.redraw()};if(y.stage){let H=()=>E.pointsAt(A.clipTime(0));M=dv(y.stage,{moving:E,shape:H,names:m,asked:()=>({...a,share:o.share}),held:B}),(e.querySelector(".crease-choice")??e.querySelector(".transport")).after(M.element)}let $=cr(i,C,[E],A);L.push(()=>$.dispose(),or(s,E,A,k))}},Object.assign(o,{clock:A,stage:y.stage,moving:E,path:x}),_&&e.querySelector("input[type=range]").focus({preventScroll:!0})}return o}function dI(n){let e=n,t=null,i=null,s={now:()=>e,replace:r=>e=r,lend:r=>t=r,hold:r=>i=r,pointsAt(r,o){return i?o?(o.set(i),o):i:(t??e).pointsAt(r,o)},verticesAt:(r,o)=>i?e.verticesOf(i,o):e.verticesAt(r,o)};return new Proxy(s,{get:(r,o)=>s[o]??e[o]})}function fI(n,e){let t=`${e.toFixed(e<10?1:0)} s`;return n.reached?`The fold path was computed in ${t}.`:`The fold path was computed in ${t}; it does not reach its goal.`}var pI=[{name:"live",title:"simulated in time"},{name:"fold",title:"slowly along its path"}];function gv(n,e,t){let i=S("div"),s=pv(),r={element:i,fold:s,panel:null,whole:"structure",refused:"",engine:null},o="live",a=null,l,c;function u(){let m=r.panel?.stage?.eye.look;l=m?{...m,closer:m.closer/Ou}:s.look??l,c=r.panel?.pace??c}function h(){u(),r.panel?.leave(),r.panel=null}r.begin=async(m,_)=>{if(!_&&r.panel)return{};let b=await s.show(m,{fresh:_,look:l});return b.shown&&(h(),r.whole=s.whole,i.contains(s.element)||i.replaceChildren(s.element)),b},r.resume=()=>s.resume(),r.show=async m=>{a=m,r.whole=a.bench?.whole??s.whole,r.refused=a.live.refused??"",!r.refused&&o==="live"?await d():await f()};async function d(){let{bench:m,live:_,warnings:b}=a;u();try{let v=await Do(Jn(m.clips[0]),m,JSON.stringify(_),x,{look:mI(l),pace:c,set:e});h(),s.clear(),i.replaceChildren(p(),v.element,...mv(b)),v.begin(),r.panel=v}catch(v){r.engine?.end(),r.engine=null,r.refused=v.message,await f()}}async function f(){h(),i.replaceChildren(...r.refused?[]:[p()],s.element,...r.refused?[g()]:[],...mv(a.warnings)),s.shows(n())||await s.show(n(),{look:l})}function p(){let m=_h(r.whole,pI,async _=>{_!==o&&(o=_,await(_==="live"?d():f()),[...i.querySelectorAll(".modes button")].find(b=>b.textContent===o)?.focus())});return m.mark(o),m.element}async function x(m,_){return r.engine?r.engine.take(m,_):(r.engine=await Po(m,_),r.engine)}function g(){let m=S("p",{className:"note"},`The motion in time is not simulated in this page: ${r.refused}. The package simulates it.`),_=S("button",{type:"button"},"Run it");return _.addEventListener("click",t),S("div",{className:"offer"},_,m)}return r}var mI=n=>n&&{...n,following:!1,closer:Ou*n.closer};function mv(n){if(!n.length)return[];let e=t=>`${t.replace(/^[a-z](?=\S* )/,i=>i.toUpperCase()).replace(/\.$/,"")}.`;return[S("h2",{},"What to know"),S("ul",{className:"warnings"},...n.map(t=>S("li",{},e(t))))]}var gI={landscape:{button:"Compute it",text:"Statics computes the equilibria, the barriers between them, and the motion under the drives.",title:"landscape"},run:{button:"Run it",text:"The package simulates the protocol, checks the energy balance and reports the outcome.",title:"run"}};async function xv(n){let e=ov(),t=Promise.resolve(),i=x=>t=t.then(x).catch(g=>e.refuse(g.message)),s=Qy({says:e,reply:d,picture:(x,g)=>u.wing.begin(x,g),model:f,resume:()=>u.wing.resume()}),r=cv(x=>i(()=>s.slide(x))),o=null,a=x=>(o=x,i(()=>o===x&&s.open(x,{}))),l=sv(n.designs,n.opened,a),c=iv((x,g)=>{r.hand(),i(()=>s.change(x,g))}),u=_I(s,r,a),h=av();function d({asked:x,base:g,reply:m,rejected:_}){document.title=`${m.title}: workbench`,document.querySelector("h1").textContent=m.title,l.show(x),c.show(m,x.settings,g);for(let[b,{text:v,why:E}]of _)c.reject(b,v,E);u.file.show(m),h.show(m),u.tabs.seen()}async function f(x){await u.wing.show(x),u.tabs.name("wing",Ot(u.wing.whole))}let p=S("div",{className:"masthead"},l.element,h.element,e.element);return document.getElementById("workbench").append(p,c.element,u.tabs.element),u.tabs.choose("wing"),await i(()=>xI(s,n)),Object.assign(s,{wing:u.wing,idle:()=>t})}async function xI(n,e){let t=ev();t&&!await n.open({design:t.design,files:t.files,unit:t.unit},t.settings)||await n.open({design:"",files:[],unit:""},e.settings)}function _I(n,e,t){let i=()=>n.asked,s=Object.fromEntries(Object.entries(gI).map(([c,u])=>[c,rv(c,u,i)])),r=gv(i,e.put,()=>{l.choose("run"),s.run.find()}),o=lv(i),a=tv(c=>t({design:"",files:[{name:`${n.reply?.name??"design"}.toml`,text:c}],unit:""})),l=uv([{name:"wing",title:"Structure",element:r.element},{name:"sheet",title:"Pattern",...o},{name:"landscape",title:"Landscape",...s.landscape},{name:"run",title:"Run",...s.run},{name:"file",title:"File",element:a.element}],"views of the design");return{tabs:l,wing:r,file:a}}var yI={run:bp,compare:G_,curves:bp,study:Sy,goals:My,parts:Wy,bench:ax,workbench:xv},Ep=JSON.parse(document.getElementById("data").textContent);Yp(Ep.reading_units);function _v(n){let e=`Moving pictures cannot be shown in this browser (${n.message}); all numbers are below.`;throw document.querySelector("main").prepend(S("p",{className:"note",role:"alert"},e)),n}function yv(n){window.forficula=n}try{let n=yI[Ep.kind](Ep);n instanceof Promise?n.then(yv,_v):yv(n)}catch(n){_v(n)}qp();No();})();
